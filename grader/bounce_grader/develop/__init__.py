"""Tools for developing the kit: tests, benchmarks, fuzzing, doctor.

May import: build, classroom.intake, common, grading, publish, sandbox, submission.
"""
