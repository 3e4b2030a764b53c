# The C++ module, for the package's own use.
from typing import Any

__version__: str

def __getattr__(name: str) -> Any: ...
