// Where the sources and what was built of them lie: for tests that read shipped files or start
// programs. In a function, not in a definition of the compiler's command line, so that an object
// does not depend on the folder in which it was compiled.
#ifndef COPPICE_TESTS_SUPPORT_FOLDERS_H_
#define COPPICE_TESTS_SUPPORT_FOLDERS_H_

#include <string>

namespace coppice {

std::string SourceFolder();  // the root of the project, without a slash at the end
std::string BinaryFolder();  // the build folder, likewise

}  // namespace coppice

#endif  // COPPICE_TESTS_SUPPORT_FOLDERS_H_
