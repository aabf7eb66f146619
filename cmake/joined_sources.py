"""Which sources of a target are compiled together, so that headers are parsed once for many.

    joined_sources.py ROOT PREFIX SOURCE...

Writes units, PREFIX1.cc, PREFIX2.cc and so on, each of which includes up to MOST of the sources, and
prints what is to be compiled in place of the sources, one path a line. Includes start at ROOT.

Sources meet in a unit only where nobody can tell: none has a word that another one of the unit gives a
meaning, in an unnamed namespace or by headers that only the other one includes. All headers come first,
so that none is read after a source gave words a meaning. Sources that define macros, or depend on them,
are compiled alone.
"""
import functools
import os
import re
import sys

MOST = 10

UNNAMED = re.compile(r'^namespace \{$(.*?)^\}  // namespace$', re.S | re.M)
NOISE = re.compile(r'//[^\n]*|"(?:[^"\\\n]|\\.)*"|\[\[.*?\]\] ?')
ARGUMENTS_OF_TEMPLATES = re.compile(r'<[^<>]*>')
TYPE = re.compile(r'(?:struct|class|enum|enum class|using|namespace|union) '
                  r'(\w+)\b(?!::| \w+[^\w ])')
NO_NAME = {'class', 'const', 'delete', 'operator', 'return', 'static_assert', 'std'}
NOTHING_NEW = re.compile(r'^namespace [\w:]+ \{$|^(?:class|struct|enum class) \w+;$', re.M)
DECLARED = re.compile(r'(?<![:\w])(\w+)\s*[(={;\[]')
FURTHER = re.compile(r', (\w+)(?: = |[({\[])')
ENUMERATORS = re.compile(r'^enum(?: \w+)?(?: : [\w:]+)? \{(.*?)\}', re.S | re.M)
OUTSIDE = re.compile(r'^(?:static .*?|using )(\w+)(?: =|\()', re.M)  # of an unnamed namespace
WORD = re.compile(r'(?<!\.)(?<!->)(?<!::)\b[A-Za-z_]\w*')
INCLUDE = re.compile(r'^#include [<"].*$', re.M)
OURS = re.compile(r'^#include "(.*)"$', re.M)
APART = re.compile(r'^ *# *(?!include)|^using namespace', re.M)


def declared(block):
    """The names that declarations introduce; those begin at the start of a line."""
    names = {word for words in ENUMERATORS.findall(block) for word in re.findall(r'\w+', words)}
    for line in block.split('\n'):
        while ARGUMENTS_OF_TEMPLATES.search(line):
            line = ARGUMENTS_OF_TEMPLATES.sub('', line)
        if not re.match(r'(\} )?[A-Za-z_]', line):
            continue
        if TYPE.match(line):
            names.add(TYPE.match(line)[1])
        elif DECLARED.search(line):
            names.add(DECLARED.search(line)[1])
            names.update(FURTHER.findall(line))
    return names - NO_NAME


def read(path):
    with open(path, encoding='utf-8') as file:
        return file.read()


@functools.lru_cache(maxsize=None)
def header(path):
    """The names that a header of ours declares, and the headers that it includes."""
    text = read(path)
    return declared(NOTHING_NEW.sub('', NOISE.sub('', text))), OURS.findall(text)


def headers(root, includes):
    """The included headers of ours, with those that they include."""
    todo, done = list(includes), set()
    while todo:
        path = os.path.join(root, todo.pop())
        if path not in done and os.path.exists(path):
            done.add(path)
            todo += header(path)[1]
    return done


class Source:
    def __init__(self, path, root):
        self.path = path
        text = read(path)
        plain = NOISE.sub('', text)
        self.includes = INCLUDE.findall(text)
        self.is_apart = bool(APART.search(text))
        self.own = set(OUTSIDE.findall(plain))
        for block in UNNAMED.findall(text):
            self.own |= declared(NOISE.sub('', block))
        self.words = set(WORD.findall(plain)) | self.own
        self.headers = headers(root, OURS.findall(text))

    def can_tell(self, other):
        """Whether a word of this one gets another meaning beside the other one."""
        return (not self.words.isdisjoint(other.own) or
                any(not self.words.isdisjoint(header(path)[0])
                    for path in other.headers - self.headers))

    def can_meet(self, other):
        return not (self.is_apart or other.is_apart or
                    self.can_tell(other) or other.can_tell(self))


def units(sources):
    """Lists of sources; each source goes to the first one that has room and where nobody can tell."""
    found = []
    for source in sources:
        for unit in found:
            if len(unit) < MOST and all(source.can_meet(other) for other in unit):
                unit.append(source)
                break
        else:
            found.append([source])
    return found


def write(path, text):
    """Only what changed, since the rest need not be compiled again."""
    if os.path.exists(path) and read(path) == text:
        return
    with open(path, 'w', encoding='utf-8') as file:
        file.write(text)


def text_of(unit, root):
    includes = sorted({include for source in unit for include in source.includes})
    includes += [f'#include "{os.path.relpath(source.path, root)}"' for source in unit]
    return '\n'.join(includes) + '\n'


def main():
    root, prefix, *sources = sys.argv[1:]
    joined = 0
    for unit in units([Source(path, root) for path in sources]):
        if len(unit) == 1:
            print(unit[0].path)
            continue
        joined += 1
        write(f'{prefix}{joined}.cc', text_of(unit, root))
        print(f'{prefix}{joined}.cc')


if __name__ == '__main__':
    main()
