#include "bt_core/live/web_files.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>

namespace coppice {
namespace {

class WebFilesTest : public ::testing::Test {
 protected:
  WebFilesTest() {
    std::filesystem::create_directory(folder_ / "page");
    Write("page/index.html", "<html>");
    Write("page/editor.wasm", std::string("\0asm", 4));
    Write("page/.hidden.html", "no");
    Write("page/notes.txt", "no");
    Write("secret.html", "no");
    std::filesystem::create_directory(folder_ / "page/folder.html");
  }
  ~WebFilesTest() override { std::filesystem::remove_all(folder_); }

  static std::filesystem::path MakeFolder() {
    std::string name = ::testing::TempDir() + "web_files_XXXXXX";
    return mkdtemp(name.data());
  }
  void Write(const char* name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  const std::filesystem::path folder_ = MakeFolder();
  const WebFiles files_{(folder_ / "page").string()};
};

TEST_F(WebFilesTest, GivesThePageAndItsParts) {
  EXPECT_EQ(files_.Find("/")->bytes, "<html>");
  EXPECT_EQ(files_.Find("/?robot=1")->bytes, "<html>");
  EXPECT_STREQ(files_.Find("/index.html")->type, "text/html; charset=utf-8");
  const std::optional<WebFile> program = files_.Find("/editor.wasm?3");
  ASSERT_TRUE(program);
  EXPECT_STREQ(program->type, "application/wasm");
  EXPECT_EQ(program->bytes.size(), 4u);
}

TEST_F(WebFilesTest, GivesNothingElse) {
  for (const char* target :
       {"", "index.html", "//index.html", "/../secret.html", "/..%2fsecret.html",
        "/page/index.html", "/.hidden.html", "/notes.txt", "/missing.html", "/folder.html",
        "/.html", "/*", "http://robot/index.html"}) {
    EXPECT_FALSE(files_.Find(target)) << target;
  }
  EXPECT_FALSE(files_.Find(std::string_view("/secret\0.html", 13)));
  EXPECT_FALSE(WebFiles("").Find("/"));
}

}  // namespace
}  // namespace coppice
