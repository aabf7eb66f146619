// fuzz_seeds FOLDER: writes the seeds to FOLDER/NAME/seed-N.
#include <filesystem>
#include <fstream>

#include "tests/fuzz/seeds.h"

#if COPPICE_FUZZ_ROBOT
#include "tests/fuzz/perception_seeds.h"
#endif
#if COPPICE_FUZZ_FILES
#include "tests/fuzz/robot_file_seeds.h"
#endif

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  int number = 0;
  auto seeds = coppice::fuzz::AllSeeds();
#if COPPICE_FUZZ_ROBOT
  seeds.emplace_back("cloud", coppice::fuzz::SomeCloud());
  seeds.emplace_back("picture", coppice::fuzz::SomeColourPicture());
  seeds.emplace_back("picture", coppice::fuzz::SomeDepthPicture());
#endif
#if COPPICE_FUZZ_FILES
  seeds.emplace_back("map", coppice::fuzz::SomeMap());
  seeds.emplace_back("message", coppice::fuzz::SomeMessage());
  seeds.emplace_back("wav", coppice::fuzz::SomeWav());
  seeds.emplace_back("wav", coppice::fuzz::SomePackedWav());
#endif
  for (const auto& [name, input] : seeds) {
    const auto folder = std::filesystem::path(argv[1]) / name;
    std::filesystem::create_directories(folder);
    std::ofstream file(folder / ("seed-" + std::to_string(++number)), std::ios::binary);
    if (!(file << input)) return 1;
  }
  return 0;
}
