"""The stub of the native module says what the module has, and the package is typed throughout."""
import ast
import pathlib
import re
import subprocess
import sys

import coppice
from coppice import _native

STUB = pathlib.Path(coppice.__file__).parent / "_native.pyi"
TREE = ast.parse(STUB.read_text())
IGNORED = {"__init__", "__iter__", "__next__", "__len__", "__call__"}  # pybind writes these itself


def told_functions(body):
    return {one.name: [a.arg for a in one.args.args] for one in body
            if isinstance(one, ast.FunctionDef)}


def told_classes():
    return {one.name: one for one in TREE.body if isinstance(one, ast.ClassDef)}


def real_names(owner):
    return {name for name in vars(owner) if not name.startswith("_")}


def real_arguments(function):
    """Those of pybind's signature, the first line of the docstring."""
    inside = re.match(r"\w+\((.*)\) -> ", function.__doc__.splitlines()[0]).group(1)
    depth, names, word = 0, [], ""
    for letter in inside + ",":
        depth += (letter in "[(") - (letter in "])")
        if letter == "," and depth == 0:
            names.append(word.split(":")[0].strip())
            word = ""
        else:
            word += letter
    return [name for name in names if name]


def test_the_module_has_the_classes_of_the_stub():
    real = {name for name, one in vars(_native).items() if isinstance(one, type)}
    assert real == set(told_classes())


def test_the_module_has_the_functions_of_the_stub():
    real = {name for name, one in vars(_native).items()
            if callable(one) and not isinstance(one, type)}
    assert real == set(told_functions(TREE.body))


def test_functions_have_the_arguments_of_the_stub():
    for name, arguments in told_functions(TREE.body).items():
        assert real_arguments(getattr(_native, name)) == arguments, name


def test_classes_have_the_members_of_the_stub():
    for name, told in told_classes().items():
        members = set(told_functions(told.body)) - IGNORED
        members |= {t.id for one in told.body if isinstance(one, ast.Assign) for t in one.targets}
        real = real_names(getattr(_native, name)) - {"name", "value", "args", "with_traceback",
                                                     "add_note"}
        assert real == members, name


def test_methods_have_the_arguments_of_the_stub():
    for name, told in told_classes().items():
        for method, arguments in told_functions(told.body).items():
            real = getattr(getattr(_native, name), method)
            if method not in IGNORED and not isinstance(real, property):
                assert real_arguments(real) == arguments, f"{name}.{method}"


def mypy(*paths):
    return subprocess.run([sys.executable, "-m", "mypy", "--strict", "--no-incremental",
                           "--cache-dir=/dev/null", "--allow-any-generics", *map(str, paths)],
                          capture_output=True, text=True, check=False)


def test_the_package_is_typed(tmp_path):
    checked = mypy(pathlib.Path(coppice.__file__).parent)
    assert checked.returncode == 0, checked.stdout


def test_ports_have_the_types_of_their_annotations(tmp_path):
    user = tmp_path / "user.py"
    user.write_text('''
from coppice import Condition, Input, Output, Status, SyncAction

class Right(SyncAction):
    lux: Input[float] = Input("brightness", unit="lx", default=1.0)
    dark: Output[bool] = Output("whether it is dark")
    def run(self) -> Status:
        self.dark = self.lux < 10
        return Status.SUCCESS

class Wrong(SyncAction):
    lux: Input[float]
    dark: Output[bool]
    def run(self) -> Status:
        self.dark = "yes"
        return self.lux.upper()
''')
    checked = mypy(user)
    lines = re.findall(r"user\.py:(\d+): error", checked.stdout)
    assert set(lines) == {"15", "16"}, checked.stdout
