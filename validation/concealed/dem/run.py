"""One test in a process of its own: python3 -m dem.run JOB.json CURVE.npz"""

import json
import sys
from pathlib import Path

import numpy as np

from dem.test import Test

if __name__ == "__main__":
    job, path = json.loads(Path(sys.argv[1]).read_text()), Path(sys.argv[2])
    curve = Test(job["base"], job["effects"], job["seed"], path.parent).run(job["program"])
    channels = {"time": curve.time, "stress": curve.stress, "strain": curve.strain}
    np.savez(path, stage=curve.stage, **channels, **curve.others)
