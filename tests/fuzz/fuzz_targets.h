// Harness functions: each takes any bytes and must neither crash nor hang.
//
// With COPPICE_FUZZ_MAIN defined, a source defines LLVMFuzzerTestOneInput, the entry that libFuzzer
// looks for, in addition.
#ifndef COPPICE_TESTS_FUZZ_FUZZ_TARGETS_H_
#define COPPICE_TESTS_FUZZ_FUZZ_TARGETS_H_

#include <string_view>

namespace coppice::fuzz {

/// The bytes as an XML file: parse, resolve, compile, tick. Checks that every position lies in the
/// text and that what compiles is idle after a halt. Returns how far it came: 0 no document, 1 an
/// incomplete project, 2 no program, 3 ticked.
int FuzzDocument(std::string_view bytes);

/// The bytes as a literal of each built-in type. What is accepted must print to a text that is
/// accepted again with the same result. Returns the number of types that took it.
int FuzzLiteral(std::string_view bytes);

}  // namespace coppice::fuzz

#endif  // COPPICE_TESTS_FUZZ_FUZZ_TARGETS_H_
