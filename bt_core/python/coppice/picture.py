"""Pictures of trees, by `coppice-export`: the painters of the editor."""
from __future__ import annotations

import pathlib
import shutil
import subprocess
import tempfile
from typing import Optional

_BESIDE = pathlib.Path(__file__).resolve().parents


def _program() -> Optional[str]:
    """That of the build folder that the module lies in, else the one that is installed."""
    import coppice._native
    build = pathlib.Path(coppice._native.__file__).resolve().parents[2] / "bin" / "coppice-export"
    return str(build) if build.exists() else shutil.which("coppice-export")


def svg_of(xml: str, tree: str) -> str:
    """The tree of a text with the models of its node types."""
    program = _program()
    if program is None:
        raise RuntimeError("pictures need coppice-export, of the package coppice-editor")
    with tempfile.TemporaryDirectory(prefix="coppice-") as folder:
        source, picture = pathlib.Path(folder, "tree.xml"), pathlib.Path(folder, "tree.svg")
        source.write_text(xml, encoding="utf-8")
        made = subprocess.run([program, str(source), "--tree", tree, "-o", str(picture)],
                              capture_output=True, text=True, check=False)
        if made.returncode != 0:
            raise RuntimeError(made.stderr.strip() or f"{program}: {made.returncode}")
        return picture.read_text(encoding="utf-8")
