"""Builds the module with CMake and puts the cars and manoeuvres into the package.

TREAD_BUILD   build folder that is used, and kept; a temporary one unless given
"""

import os
import re
import shutil
import subprocess
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parents[2]


class CMakeBuild(build_ext):
    """Stands for the compiler of setuptools: CMake builds and installs the package as it is on Debian."""

    def build_extension(self, ext):
        target = Path(self.get_ext_fullpath(ext.name)).resolve().parent
        build = Path(os.environ.get("TREAD_BUILD") or Path(self.build_temp).resolve())
        if not (build / "CMakeCache.txt").exists():
            self.cmake("-S", ROOT, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DTREAD_PYTHON=ON", "-DTREAD_TESTS=OFF",
                       "-DTREAD_DEMO=OFF", "-DTREAD_WERROR=OFF", *self.generator())
        self.cmake("--build", build, "--target", "tread_python", "--parallel", str(os.cpu_count()))
        staged = Path(self.build_temp).resolve() / "staged"
        self.cmake("--install", build, "--component", "python", "--prefix", staged, "--strip")
        shutil.copytree(next(staged.rglob("_tread*.so")).parent, target, dirs_exist_ok=True)
        for folder in ("vehicles", "scenarios"):
            shutil.copytree(ROOT / folder, target / folder, dirs_exist_ok=True)

    @staticmethod
    def generator():
        return ["-G", "Ninja"] if shutil.which("ninja") else []

    @staticmethod
    def cmake(*words):
        subprocess.run(["cmake", *map(str, words)], check=True)


def version():
    return re.search(r"project\(tread VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


setup(
    version=version(),
    packages=["tread"],
    package_data={"tread": ["py.typed", "*.pyi"]},
    ext_modules=[Extension("tread._tread", [])],
    cmdclass={"build_ext": CMakeBuild},
    zip_safe=False,
)
