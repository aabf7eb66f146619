#include "bt_core/live/web/web_files.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "tests/support/temporary_folder.h"

namespace coppice {
namespace {

class WebFilesTest : public ::testing::Test {
 protected:
  WebFilesTest() {
    std::filesystem::create_directory(folder_.Path("page"));
    Write("page/index.html", "<html>");
    Write("page/editor.wasm", std::string("\0asm", 4));
    Write("page/.hidden.html", "no");
    Write("page/notes.txt", "no");
    Write("secret.html", "no");
    std::filesystem::create_directory(folder_.Path("page/folder.html"));
  }
  void Write(const char* name, const std::string& text) { WriteFile(folder_.Path(name), text); }

  static std::string Read(const std::optional<WebFile>& file) {
    return file ? ReadFile(file->path) : "nothing";
  }

  const TemporaryFolder folder_;
  const WebFiles files_{folder_.Path("page")};
};

TEST_F(WebFilesTest, GivesThePageAndItsParts) {
  EXPECT_EQ(Read(files_.Find("/")), "<html>");
  EXPECT_EQ(Read(files_.Find("/?robot=1")), "<html>");
  EXPECT_STREQ(files_.Find("/index.html")->type, "text/html; charset=utf-8");
  const std::optional<WebFile> program = files_.Find("/editor.wasm?3");
  ASSERT_TRUE(program);
  EXPECT_STREQ(program->type, "application/wasm");
  EXPECT_EQ(Read(program).size(), 4u);
}

TEST_F(WebFilesTest, GivesTheCompressedFileToWhoAcceptsIt) {
  Write("page/index.html.gz", "packed");
  EXPECT_EQ(Read(files_.Find("/", true)), "packed");
  EXPECT_TRUE(files_.Find("/", true)->is_gzipped);
  EXPECT_STREQ(files_.Find("/", true)->type, "text/html; charset=utf-8") << "that of what is in it";
  EXPECT_EQ(Read(files_.Find("/", false)), "<html>");
  EXPECT_FALSE(files_.Find("/editor.wasm", true)->is_gzipped) << "there is none";
  EXPECT_FALSE(files_.Find("/index.html.gz", true)) << "it is no part of the page itself";
}

TEST_F(WebFilesTest, ACompressedFileThatIsOlderIsOfAnotherPage) {
  Write("page/index.html.gz", "packed");
  const std::string page = folder_.Path("page/index.html");
  std::filesystem::last_write_time(
      folder_.Path("page/index.html.gz"),
      std::filesystem::last_write_time(page) - std::chrono::seconds(10));
  EXPECT_EQ(Read(files_.Find("/", true)), "<html>");
}

TEST(AcceptsGzip, AsTheClientSays) {
  for (const char* field :
       {"gzip", "deflate, gzip;q=0.5, br", "GZIP", "*", "br, *;q=0.1", "x-gzip", " gzip ; q=1.0"}) {
    EXPECT_TRUE(AcceptsGzip(field)) << field;
  }
  for (const char* field : {"", "identity", "gzip;q=0", "gzip;q=0.000, *", "*;q=0", "br", ",;,",
                            "gzipped", ";", "q=1"}) {
    EXPECT_FALSE(AcceptsGzip(field)) << field;
  }
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
