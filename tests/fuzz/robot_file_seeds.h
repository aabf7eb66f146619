// Inputs from which the harnesses of the robot's files begin.
#ifndef COPPICE_TESTS_FUZZ_ROBOT_FILE_SEEDS_H_
#define COPPICE_TESTS_FUZZ_ROBOT_FILE_SEEDS_H_

#include <string>

namespace coppice::fuzz {

std::string SomeMap();        ///< for FuzzMap
std::string SomeMessage();    ///< for FuzzMessage
std::string SomeWav();        ///< for FuzzWav
std::string SomePackedWav();  ///< the same, of a sound that is not kept sample by sample

}  // namespace coppice::fuzz

#endif  // COPPICE_TESTS_FUZZ_ROBOT_FILE_SEEDS_H_
