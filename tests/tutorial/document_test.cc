// docs/tutorial.md shows code of this folder: each block is exactly the part that it names.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "tests/support/folders.h"

namespace coppice {
namespace {

using Lines = std::vector<std::string>;

Lines LinesOf(const std::string& path) {
  std::ifstream file(SourceFolder() + "/" + path);
  EXPECT_TRUE(file) << path << " cannot be read";
  Lines lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

std::string WithoutIndent(const Lines& lines) {
  std::size_t indent = std::string::npos;
  for (const std::string& line : lines) indent = std::min(indent, line.find_first_not_of(' '));
  std::string text;
  for (const std::string& line : lines) {
    text += line.empty() ? "\n" : line.substr(indent) + "\n";
  }
  return text;
}

std::string Trimmed(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(' ');
  return begin == std::string::npos ? "" : line.substr(begin);
}

// The lines between `// [name]` and `// [name end]`; empty if they are not there.
std::string PartOf(const std::string& path, const std::string& name) {
  Lines part;
  bool inside = false;
  for (const std::string& line : LinesOf(path)) {
    if (Trimmed(line) == "// [" + name + " end]") return WithoutIndent(part);
    if (inside) part.push_back(line);
    if (Trimmed(line) == "// [" + name + "]") inside = true;
  }
  return "";
}

struct Block {
  std::string before;  // the line above the fence
  std::string text;
};

std::vector<Block> CodeBlocks() {
  std::vector<Block> blocks;
  std::string before;
  bool inside = false;
  for (const std::string& line : LinesOf("docs/tutorial.md")) {
    if (inside && line == "```") {
      inside = false;
    } else if (inside) {
      blocks.back().text += line + "\n";
    } else if (line == "```cpp") {
      inside = true;
      blocks.push_back({before, ""});
    }
    before = line;
  }
  return blocks;
}

TEST(Tutorial, EveryBlockOfCodeIsThePartOfTheTestThatItNames) {
  const std::regex source("<!-- (tests/tutorial/\\w+\\.(?:cc|h)) \\[(\\w+)\\] -->");
  const std::vector<Block> blocks = CodeBlocks();
  EXPECT_FALSE(blocks.empty());
  for (const Block& block : blocks) {
    std::smatch match;
    ASSERT_TRUE(std::regex_match(block.before, match, source)) << "no source above the block\n"
                                                               << block.text;
    const std::string part = PartOf(match[1], match[2]);
    EXPECT_FALSE(part.empty()) << block.before;
    EXPECT_EQ(block.text, part) << block.before;
  }
}

TEST(Tutorial, EveryLinkLeadsToAFile) {
  const std::regex link("[^\\[]\\]\\(([^)#]+)\\)");
  int links = 0;
  for (const std::string& line : LinesOf("docs/tutorial.md")) {
    for (std::sregex_iterator it(line.begin(), line.end(), link), end; it != end; ++it, ++links) {
      const std::string target = (*it)[1];
      EXPECT_TRUE(std::ifstream(SourceFolder() + "/docs/" + target)) << target;
    }
  }
  EXPECT_GT(links, 0);
}

}  // namespace
}  // namespace coppice
