// What once crashed a harness must not do so again: regressions/NAME/* are inputs of FuzzName.
#ifndef COPPICE_TESTS_FUZZ_REGRESSIONS_H_
#define COPPICE_TESTS_FUZZ_REGRESSIONS_H_

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "tests/support/folders.h"

namespace coppice::fuzz {

inline void RunRegressions(const std::string& name, int (*harness)(std::string_view)) {
  const auto folder = std::filesystem::path(SourceFolder() + "/tests/fuzz/regressions") / name;
  if (!std::filesystem::exists(folder)) return;  // nothing has crashed yet
  for (const auto& input : std::filesystem::directory_iterator(folder)) {
    SCOPED_TRACE(input.path());
    std::ifstream file(input.path(), std::ios::binary);
    harness(std::string(std::istreambuf_iterator<char>(file), {}));
  }
}

}  // namespace coppice::fuzz

#endif  // COPPICE_TESTS_FUZZ_REGRESSIONS_H_
