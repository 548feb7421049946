"""Runs the program in a folder of its own and says what it did."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM, BUILD, SOURCE = (pathlib.Path(a) for a in sys.argv[1:4])


class CommandLineTest(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._folder.name)

    def tearDown(self):
        self._folder.cleanup()

    def lambert(self, *arguments, status=0):
        done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, status, f"lambert {' '.join(map(str, arguments))}\n{done.stdout}{done.stderr}")
        return done

    def files(self):
        return sorted(p.name for p in self.folder.iterdir())

    def json(self, name):
        return json.loads((self.folder / name).read_text())


def main():
    unittest.main(argv=sys.argv[:1], verbosity=2)
