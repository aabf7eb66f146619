#include "editor/export/write_picture.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/editor/app/program.h"
#include "tests/editor/driver.h"
#include "tests/editor/export/painted.h"

namespace coppice::editor {
namespace {

TEST(WritePicture, TheEndingSaysTheFormat) {
  EXPECT_EQ(FormatOf("a/b.svg"), PictureFormat::kSvg);
  EXPECT_EQ(FormatOf("B.PNG"), PictureFormat::kPng);
  EXPECT_EQ(FormatOf("b.gif"), std::nullopt);
  EXPECT_EQ(FormatOf("svg"), std::nullopt);
}

TEST(WritePicture, EveryFormatBeginsAsItShould) {
  const TemporaryFile folder("x", "");
  const Painted painted("<A><B/></A>", "T");
  const std::pair<const char*, const char*> kBeginnings[] = {{"t.svg", "<svg "},
                                                             {"t.pdf", "%PDF-1.4"},
                                                             {"t.png", "\x89PNG"},
                                                             {"t.dot", "digraph {"},
                                                             {"t.md", "## T"}};
  for (const auto& [name, beginning] : kBeginnings) {
    const std::string path = folder.folder() + "/" + name;
    EXPECT_EQ(WritePicture(painted.painting, path, 1).problem(), "");
    const std::string text = ReadFile(path);
    EXPECT_EQ(text.substr(0, std::string(beginning).size()), beginning);
  }
}

TEST(WritePicture, SaysWhyAFileCannotBeWritten) {
  const Painted painted("<A/>");
  for (const char* path : {"/nowhere/t.svg", "/nowhere/t.png", "/nowhere/t.md"}) {
    const std::string wrong = WritePicture(painted.painting, path, 1).problem();
    EXPECT_NE(wrong.find("/nowhere/t"), std::string::npos) << wrong;
  }
  EXPECT_NE(WritePicture(painted.painting, "t.gif", 1).problem().find(".svg"), std::string::npos);
}

}  // namespace
}  // namespace coppice::editor
