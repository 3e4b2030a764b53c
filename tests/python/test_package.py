"""The package as its users meet it: examples, descriptions, types, installation by pip."""

import ast
import importlib.util
import io
import os
import pydoc
import shutil
import subprocess
import sys
import unittest
from contextlib import redirect_stdout
from pathlib import Path

from places import SOURCE, WithScratch

import tread

PACKAGE = Path(tread.__file__).parent


def has(module):
    return importlib.util.find_spec(module) is not None


class Examples(WithScratch):
    def run_example(self, name, *words):
        file = SOURCE / "tools/python/examples" / name
        arguments, out = sys.argv, io.StringIO()
        try:
            sys.argv = [str(file), *map(str, words)]
            with redirect_stdout(out):
                exec(compile(file.read_text(), str(file), "exec"), {"__name__": "__main__"})
        finally:
            sys.argv = arguments
        return out.getvalue()

    def test_they_run(self):
        self.assertIn("Roll gradient", self.run_example("step_steer.py"))
        self.assertEqual(self.run_example("understeer_curve.py").count("understeer"), 3)
        self.assertIn("best gain", self.run_example("vector_env.py", 0.5))

    @unittest.skipUnless(has("matplotlib"), "matplotlib is not installed: no pictures")
    def test_a_picture(self):
        self.run_example("step_steer.py", self.scratch / "a.png")
        self.assertEqual((self.scratch / "a.png").read_bytes()[:4], b"\x89PNG")

    def test_the_guide(self):
        text = (SOURCE / "tools/python/README.md").read_text()
        blocks = [block.split("```")[0] for block in text.split("```python\n")[1:]]
        self.assertGreater(len(blocks), 5)
        names = {}
        here = os.getcwd()
        os.chdir(self.scratch)
        try:
            for block in blocks:
                if "# needs" not in block:
                    with redirect_stdout(io.StringIO()):
                        exec(compile(block, "README.md", "exec"), names)
        finally:
            os.chdir(here)


class Descriptions(unittest.TestCase):
    def test_every_public_name_has_a_description(self):
        for name in tread.__all__:
            thing = getattr(tread, name)
            self.assertTrue((thing.__doc__ or "").strip(), name)
            self.assertEqual(thing.__module__, "tread", name)
            for inner, member in vars(thing).items() if isinstance(thing, type) else ():
                if not inner.startswith("_") and callable(member):
                    self.assertTrue((member.__doc__ or "").strip(), f"{name}.{inner}")

    def test_help_names_what_there_is(self):
        text = pydoc.plain(pydoc.render_doc(tread))
        for words in ("class Log", "run(vehicle", "steering-wheel angle, positive to the left", "pneumatic trail"):
            self.assertIn(words, text)

    def test_describe(self):
        mass = next(row for row in tread.describe("vehicle") if row["path"] == "mass")
        self.assertEqual(mass["unit"], "kg")
        self.assertIn({"path": "scenario"}, tread.describe())
        with self.assertRaisesRegex(tread.InputError, 'did you mean "vehicle"'):
            tread.describe("vehicel")

    def test_the_types_are_those_of_the_descriptions(self):
        self.assertTrue((PACKAGE / "py.typed").exists())
        stub = ast.parse((PACKAGE / "_described.pyi").read_text())
        classes = {node.name: node for node in stub.body if isinstance(node, ast.ClassDef)}
        fields = {name: [line.target.id for line in node.body if isinstance(line, ast.AnnAssign)]
                  for name, node in classes.items()}
        self.assertEqual(fields["TyreForces"], list(tread.TyreForces.__dataclass_fields__))
        for name in fields["VehicleInput"]:
            self.assertTrue(hasattr(tread.VehicleInput, name))


@unittest.skipUnless(has("pip") and has("setuptools") and os.environ.get("TREAD_BUILD"), "no pip here, or no build folder")
class Pip(WithScratch):
    def test_an_installed_package_finds_its_cars(self):
        source = self.scratch / "copy/tools/python"  # setuptools writes beside its sources
        source.parent.mkdir(parents=True)
        shutil.copytree(SOURCE / "tools/python", source, ignore=shutil.ignore_patterns("build", "*.egg-info"))
        for name in ("CMakeLists.txt", "vehicles", "scenarios"):
            (self.scratch / "copy" / name).symlink_to(SOURCE / name)
        target = self.scratch / "site"
        words = [sys.executable, "-m", "pip", "install", "--quiet", "--no-build-isolation", "--no-index", "--no-deps",
                 "--disable-pip-version-check", "--root-user-action=ignore", "--target", target, source]
        subprocess.run(words, check=True, capture_output=True)
        check = "import tread; print(tread.run('compact', 'step_steer_80').samples, tread.__file__)"
        told = subprocess.run([sys.executable, "-c", check], env={**os.environ, "PYTHONPATH": str(target)},
                              cwd=self.scratch, check=True, capture_output=True, text=True).stdout
        self.assertIn(str(target), told)
        self.assertTrue((target / "tread/_described.pyi").exists())


if __name__ == "__main__":
    unittest.main()
