#!/usr/bin/env python3
"""Puts the pages of the site together: make_pages.py SOURCE PROGRAMS PAGES.

SOURCE is the project, PROGRAMS the folder with coppice and coppice-export. PAGES is made anew:
- README.md as index.md, and docs/*.md with their pictures, as they are;
- every other file that a page links to, as a page of its own below files/;
- headers.md, and a page for every public header of the engine;
- nodes.md: what each built-in node does, its ports, and its picture by coppice-export.
Files of docs that no page of the menu names are an error.
"""
import html
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

LINK = re.compile(r"(\]\()([^)#\s]+)((?:#[^)\s]*)?\))")
LANGUAGES = {".h": "cpp", ".cc": "cpp", ".xml": "xml", ".urdf": "xml", ".yaml": "yaml",
             ".json": "json", ".py": "python", ".service": "ini", ".csv": "text"}
CATEGORIES = ["Control", "Decorator", "Condition", "Action"]


class Site:
    def __init__(self, source, programs, pages):
        self.source, self.programs, self.pages = source, programs, pages
        self.files = set()  # of the project, that have a page below files/

    def make(self):
        shutil.rmtree(self.pages, ignore_errors=True)
        self.pages.mkdir(parents=True)
        shutil.copytree(self.source / "docs/pictures", self.pages / "pictures")
        self.write("index.md", self.source / "README.md")
        for page in sorted((self.source / "docs").glob("*.md")):
            self.write(page.name, page)
        self.make_headers()
        self.make_nodes()
        for path in sorted(self.files):
            self.make_file(path)

    def write(self, name, original):
        text = original.read_text()
        change = lambda match: match[1] + self.target(original, match[2]) + match[3]
        (self.pages / name).write_text(LINK.sub(change, text))

    def target(self, original, link):
        """Where the link of that file leads on the site."""
        if ":" in link:
            return link
        path = (original.parent / link).resolve()
        if not path.exists():
            sys.exit(f"{original}: {link} does not exist")
        docs = self.source / "docs"
        if docs in path.parents:
            return str(path.relative_to(docs))
        if path == self.source / "README.md":
            return "index.md"
        if path.is_dir():
            sys.exit(f"{original}: {link} is a folder")
        self.files.add(path.relative_to(self.source))
        return f"files/{path.relative_to(self.source)}.md"

    def make_file(self, path):
        text = (self.source / path).read_text()
        page = self.pages / f"files/{path}.md"
        page.parent.mkdir(parents=True, exist_ok=True)
        prose = ""
        if path.suffix == ".h":
            prose, text = split_header(text)
        language = LANGUAGES.get(path.suffix, "text")
        fence = "````"
        page.write_text(f"# {path.name}\n\n`{path}`\n\n{prose}\n\n{fence}{language}\n{text}{fence}\n")

    def make_headers(self):
        lines = ["# Headers", "", "What a program includes; each says what it is for, its units, its threads "
                 "and its errors.", ""]
        for room in ["base", "data", "model", "engine", "nodes", "testing", "record", "live/server",
                     "analysis"]:
            lines += [f"## bt_core/{room}", "", "| header | |", "|---|---|"]
            for path in sorted((self.source / "bt_core" / room).glob("*.h")):
                relative = path.relative_to(self.source)
                self.files.add(relative)
                summary = split_header(path.read_text())[0].split("\n\n")[0].replace("\n", " ")
                first = re.split(r"(?<=[.:]) ", summary)[0].replace("|", "\\|")
                lines.append(f"| [{path.name}](files/{relative}.md) | {first} |")
            lines.append("")
        (self.pages / "headers.md").write_text("\n".join(lines))

    def make_nodes(self):
        told = subprocess.run([self.programs / "coppice", "nodes", "--xml"], check=True,
                              capture_output=True, text=True).stdout
        models = xml.fromstring(told).find("TreeNodesModel")
        lines = ["# Nodes", "", "The node types that are built in. What they do tick by tick is in "
                 "[semantics](semantics.md); the same list in a shell: `coppice nodes`.", ""]
        (self.pages / "nodes").mkdir()
        for category in CATEGORIES:
            lines += [f"## {category}s", ""]
            for model in models.findall(category):
                lines += self.node(category, model)
        (self.pages / "nodes.md").write_text("\n".join(lines))

    def node(self, category, model):
        name = model.get("ID")
        self.draw(category, model)
        description = model.find("MetadataFields/Metadata").get("description")
        lines = [f"### {name}", "", html.escape(description, quote=False), "",
                 f"![{name}](nodes/{name}.svg)", ""]
        ports = [port for port in model if port.tag.endswith("_port")]
        if ports:
            lines += ["| port | | type | default | meaning |", "|---|---|---|---|---|"]
        for port in ports:
            default = f"`{port.get('default')}`" if port.get("default") is not None else ""
            meaning = html.escape(port.text or "", quote=False).replace("|", "\\|")
            lines.append(f"| `{port.get('name')}` | {port.tag[:-5]} | "
                         f"{port.get('type', '').replace('BT::AnyTypeAllowed', 'any')} | {default} "
                         f"| {meaning} |")
        return lines + [""]

    def draw(self, category, model):
        """The node with as many children as it usually has."""
        children = {"Control": 3, "Decorator": 1}.get(category, 0)
        name = model.get("ID")
        given = "".join(f' {port.get("name")}="{{{port.get("name")}}}"' for port in model
                        if port.tag.endswith("_port") and port.get("default") is None)
        names = ["first", "second", "third"] if children > 1 else ["child"]
        inside = "".join(f'<AlwaysSuccess name="{n}"/>' for n in names[:children])
        tree = (f'<root BTCPP_format="4"><BehaviorTree ID="Example"><{name}{given}>{inside}'
                f"</{name}></BehaviorTree></root>")
        with tempfile.NamedTemporaryFile("w", suffix=".xml") as file:
            file.write(tree)
            file.flush()
            drawn = subprocess.run([self.programs / "coppice-export", file.name, "-o",
                                    self.pages / f"nodes/{name}.svg"],
                                   capture_output=True, text=True)
        if drawn.returncode != 0:
            sys.exit(f"{name}: {drawn.stderr}")


def split_header(text):
    """The comment at the beginning of a header, as a page's text; and the rest."""
    comment = []
    lines = text.splitlines(keepends=True)
    while lines and lines[0].startswith("//"):
        comment.append(lines.pop(0)[2:].rstrip())
    prose = []
    for line in comment:  # what is indented by more than a blank is code
        is_code = line.startswith("   ")
        prose.append(" " + line if is_code else line[1:])
    text = "\n".join(prose)
    return re.sub(r"(?m)(^\S.*\n)(?=    )", r"\1\n", text), "".join(lines)


def check_menu(source, pages):
    menu = (source / "docs/site/mkdocs.yml").read_text()
    for page in pages.glob("*.md"):
        if f": {page.name}\n" not in menu:
            sys.exit(f"docs/site/mkdocs.yml: {page.name} is not in the menu")


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    source, programs, pages = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    Site(source, programs, pages).make()
    check_menu(source, pages)


if __name__ == "__main__":
    main()
