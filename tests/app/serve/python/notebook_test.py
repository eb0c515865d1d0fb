"""Executes the notebook beside the package: by Jupyter where it is, else its cells one after the other."""

import json
import os
import pathlib
import sys
import tempfile
import unittest

import vitrine

NOTEBOOK = pathlib.Path(vitrine.__file__).parents[1] / "sweep.ipynb"

try:
    import matplotlib.image
except ImportError:
    print("matplotlib is not here (python3-matplotlib)")
    sys.exit(77)
try:
    import ipykernel  # noqa: F401
    import nbclient
    import nbformat
except ImportError:
    nbclient = None


class NotebookTest(unittest.TestCase):
    def test_it_runs_and_draws_error_against_time(self):
        with tempfile.TemporaryDirectory() as folder:
            (self.run_by_jupyter if nbclient else self.run_cells)(folder)
            picture = matplotlib.image.imread(os.path.join(folder, "sweep.png"))
        self.assertGreater(picture[:, :, :3].std(), 0.01)

    def run_by_jupyter(self, folder):
        notebook = nbformat.read(NOTEBOOK, as_version=4)
        nbformat.validate(notebook)
        client = nbclient.NotebookClient(notebook, timeout=600, resources={"metadata": {"path": folder}})
        client.execute()
        outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
        self.assertFalse([output for output in outputs if output.output_type == "error"])
        pictures = [output for output in outputs if "image/png" in output.get("data", {})]
        self.assertEqual(len(pictures), 2)

    def run_cells(self, folder):
        matplotlib.use("Agg")
        names, before = {}, os.getcwd()
        os.chdir(folder)
        try:
            for cell in json.loads(NOTEBOOK.read_text(encoding="utf-8"))["cells"]:
                if cell["cell_type"] == "code":
                    exec("".join(cell["source"]), names)
            self.assertEqual(len(names["rows"]), 9)
            self.assertTrue(all(row["ms"] > 0 for row in names["rows"]))
        finally:
            os.chdir(before)
            if "v" in names:
                names["v"].close()

    def test_it_holds_no_outputs(self):
        for cell in json.loads(NOTEBOOK.read_text(encoding="utf-8"))["cells"]:
            self.assertFalse(cell.get("outputs"))


if __name__ == "__main__":
    unittest.main()
