"""Builds the module with CMake and puts the cars and manoeuvres into the package.

TREAD_BUILD   folder in which CMake has built tread_python; unless given, it is built in a temporary one
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parents[2]


class CMakeBuild(build_ext):
    """Stands for the compiler of setuptools: CMake builds and installs the package as it is on Debian."""

    def build_extension(self, ext):
        target = Path(self.get_ext_fullpath(ext.name)).resolve().parent
        temporary = Path(self.build_temp).resolve()
        build = Path(os.environ.get("TREAD_BUILD") or self.built(temporary))
        staged = temporary / "staged"
        self.cmake("--install", build, "--component", "python", "--prefix", staged, "--strip")
        shutil.copytree(next(staged.rglob("_tread*.so")).parent, target, dirs_exist_ok=True)
        for folder in ("vehicles", "scenarios"):
            shutil.copytree(ROOT / folder, target / folder, dirs_exist_ok=True)

    def built(self, folder):
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []
        self.cmake("-S", ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DTREAD_PYTHON=ON", "-DTREAD_TESTS=OFF",
                   "-DTREAD_DEMO=OFF", "-DTREAD_WERROR=OFF", f"-DPython3_EXECUTABLE={sys.executable}", *generator)
        self.cmake("--build", folder, "--target", "tread_python", "--parallel", str(os.cpu_count()))
        return folder

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
