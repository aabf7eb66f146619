// fuzz_seeds FOLDER: writes the seeds to FOLDER/NAME/seed-N.
#include <filesystem>
#include <fstream>

#include "tests/fuzz/seeds.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  int number = 0;
  for (const auto& [name, input] : coppice::fuzz::AllSeeds()) {
    const auto folder = std::filesystem::path(argv[1]) / name;
    std::filesystem::create_directories(folder);
    std::ofstream file(folder / ("seed-" + std::to_string(++number)), std::ios::binary);
    if (!(file << input)) return 1;
  }
  return 0;
}
