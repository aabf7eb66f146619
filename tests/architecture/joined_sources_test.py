"""What is compiled in place of the sources of a target (cmake/joined_sources.py)."""
import os
import subprocess
import sys
import tempfile
import unittest

SCRIPT = os.path.join(os.path.dirname(__file__), '../../cmake/joined_sources.py')


def source(hidden='', seen=''):
    return (f'#include <string>\n\nnamespace coppice {{\nnamespace {{\n\n{hidden}\n\n}}  // namespace\n\n'
            f'{seen}\n\n}}  // namespace coppice\n')


class JoinedSources(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def header(self, name, text):
        with open(os.path.join(self.folder, name), 'w', encoding='utf-8') as file:
            file.write(text)

    def compiled(self, *texts):
        """The names of the sources 0.cc, 1.cc ... with `texts`, by what is compiled."""
        paths = [os.path.join(self.folder, f'{number}.cc') for number in range(len(texts))]
        for path, text in zip(paths, texts):
            with open(path, 'w', encoding='utf-8') as file:
                file.write(text)
        prefix = os.path.join(self.folder, 'unit')
        said = subprocess.run([sys.executable, '-B', SCRIPT, self.folder, prefix, *paths],
                              check=True, capture_output=True, text=True).stdout.split()
        return [self.sources_of(path) if path.startswith(prefix) else [os.path.basename(path)]
                for path in said]

    @staticmethod
    def sources_of(unit):
        with open(unit, encoding='utf-8') as file:
            return [line.split('"')[1] for line in file if line.endswith('.cc"\n')]

    def assert_apart(self, first, second):
        self.assertEqual(self.compiled(first, second), [['0.cc'], ['1.cc']])

    def test_sources_that_share_no_name_are_one(self):
        self.assertEqual(self.compiled(source('int First() { return 1; }'), source('int Second();')),
                         [['0.cc', '1.cc']])

    def test_every_source_is_compiled_once_and_never_more_than_ten_at_a_time(self):
        found = self.compiled(*(source(f'int F{number}();') for number in range(23)))
        self.assertEqual([len(unit) for unit in found], [10, 10, 3])
        self.assertEqual(sorted(name for unit in found for name in unit),
                         sorted(f'{number}.cc' for number in range(23)))

    def test_a_name_that_two_sources_keep_to_themselves_parts_them(self):
        for name in ('int Same(int a) {\n  return a;\n}',
                     'constexpr int kOther = 1, kSame = 2;',
                     'const char* const kSame[] = {"a"};',
                     'template <typename T>\nstd::map<T, std::vector<T>> Same(T a);',
                     '[[noreturn]] void Same();',
                     'class Same final {\n};',
                     'enum Letter { kA, kSame };',
                     'using Same = std::string;',
                     'struct sigaction same;',
                     'struct {\n  int a;\n} constexpr kSame{1};'):
            with self.subTest(name):
                self.assert_apart(source(name), source(name))
                self.assert_apart(source(name), source(seen='Same(same, kSame);'))

    def test_a_source_is_not_joined_with_one_that_has_another_meaning_for_a_word_of_it(self):
        self.assert_apart(source('int Find(const char* text);'), source(seen='int a = Find("a");'))
        self.assert_apart(source(seen='int a = Find("a");'), source('int Find(const char* text);'))

    def test_a_source_is_not_joined_with_one_whose_headers_have_another_meaning_for_a_word_of_it(self):
        for name in ('int Find(const char* text);', 'struct Find {\n};', 'using Find = int;'):
            with self.subTest(name):
                self.header('other.h', '#include "further.h"\n')
                self.header('further.h', f'namespace coppice {{\n\n{name}\n\n}}  // namespace coppice\n')
                self.assert_apart(source(seen='int a = Find("a");'), '#include "other.h"\n')

    def test_headers_that_both_include_and_members_of_classes_part_no_sources(self):
        self.header('both.h', 'int Find(const char* text);\n')
        self.header('other.h', '#include "both.h"\nclass Text {\n  int Find();\n};\n')
        self.assertEqual(self.compiled('#include "both.h"\n' + source(seen='int a = Find("a");'),
                                       '#include "other.h"\n'),
                         [['0.cc', '1.cc']])

    def test_members_and_words_in_strings_and_comments_are_no_meeting(self):
        self.assertEqual(
            self.compiled(source('int Find();'),
                          source(seen='int a = text.Find("Find") + Text::Find();  // Find')),
            [['0.cc', '1.cc']])

    def test_a_source_with_macros_is_compiled_alone(self):
        self.assert_apart('#define A 1\n', source())
        self.assert_apart(source(), '#ifdef A\n#endif\n')

    def test_headers_are_read_before_all_sources(self):
        self.compiled('#include <vector>\n', '#include "own.h"\n')
        with open(os.path.join(self.folder, 'unit1.cc'), encoding='utf-8') as file:
            self.assertEqual(file.read(), '#include "own.h"\n#include <vector>\n'
                                          '#include "0.cc"\n#include "1.cc"\n')

    def test_a_unit_that_stays_as_it_is_need_not_be_compiled_again(self):
        self.compiled(source(), source())
        unit = os.path.join(self.folder, 'unit1.cc')
        os.utime(unit, (1, 1))
        self.compiled(source('int a;'), source())
        self.assertEqual(os.stat(unit).st_mtime, 1)


if __name__ == '__main__':
    unittest.main()
