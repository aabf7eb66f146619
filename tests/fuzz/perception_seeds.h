// Inputs from which the harnesses of what the robot's sensors send begin.
#ifndef COPPICE_TESTS_FUZZ_PERCEPTION_SEEDS_H_
#define COPPICE_TESTS_FUZZ_PERCEPTION_SEEDS_H_

#include <string>

namespace coppice::fuzz {

/// A small cloud for FuzzCloud.
std::string SomeCloud();
/// Small pictures for FuzzPicture.
std::string SomeColourPicture();
std::string SomeDepthPicture();

}  // namespace coppice::fuzz

#endif  // COPPICE_TESTS_FUZZ_PERCEPTION_SEEDS_H_
