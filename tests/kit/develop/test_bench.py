"""./kit bench must still find all that it compiles, long after it was last run."""

from pathlib import Path

import pytest
from bounce_grader.develop import bench


@pytest.mark.long
def test_the_plain_way_still_compiles_links_and_passes(tmp_path: Path) -> None:
    (line,) = bench._plain(tmp_path)
    assert line.value > 0
