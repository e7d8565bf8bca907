"""Where the gradings of a class run: here, on a Dask cluster, or under Slurm."""
