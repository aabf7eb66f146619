// What stands in a file, for example in the log of a program that a test has started.
#ifndef COPPICE_TESTS_ROBOT_APP_TEXT_OF_H_
#define COPPICE_TESTS_ROBOT_APP_TEXT_OF_H_

#include <fstream>
#include <sstream>
#include <string>

namespace coppice::robot {

/// Empty if there is no such file.
inline std::string TextOf(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

}  // namespace coppice::robot

#endif  // COPPICE_TESTS_ROBOT_APP_TEXT_OF_H_
