"""The version of the wheel, in Python's notation."""

import pathlib
import sys
import unittest

sys.dont_write_bytecode = True  # the sources stay as they are
sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "src" / "Football.Physics.Python"))
from build_wheel import python_version  # noqa: E402


class WheelTests(unittest.TestCase):
    def test_versions(self):
        for version, expected in {
            "0.1.0": "0.1.0",
            "0.2.1-alpha.0.3": "0.2.1a0.post3",
            "0.3.0-beta.1": "0.3.0b1",
            "0.3.0-rc.2": "0.3.0rc2",
            "0.3.0-rc.2.14": "0.3.0rc2.post14",
        }.items():
            self.assertEqual(python_version(version), expected)


if __name__ == "__main__":
    unittest.main()
