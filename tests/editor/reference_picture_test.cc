#include "tests/editor/reference_picture.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(ReferencePicture, WhatIsWrittenCanBeRead) {
  const TemporaryFile folder("x", "");
  Image image = MakeImage(4, 2, 0xFF102030U);
  image.pixels[5] = 0xFFE0A010U;
  ASSERT_EQ(WritePng(image, folder.folder() + "/a.png").problem(), "");
  const auto read = ReadPng(folder.folder() + "/a.png");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->pixels, image.pixels);
  EXPECT_FALSE(ReadPng(folder.path())) << "no picture";
}

TEST(ReferencePicture, ATileThatIsMissingIsSeen) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames(10);
  const Image before = HalfSize(driver.editor.Picture());
  EXPECT_EQ(DifferentPart(before, HalfSize(driver.editor.Picture())), 0);
  driver.editor.state().screen.tiles.types = false;
  driver.Frames();
  EXPECT_GT(DifferentPart(before, HalfSize(driver.editor.Picture())), 0.005);
  EXPECT_EQ(DifferentPart(before, MakeImage(1, 1, 0)), 1) << "another size";
}

TEST(ReferencePicture, AMissingReferenceIsNoAgreement) {
  if (std::getenv("COPPICE_UPDATE_REFERENCE")) GTEST_SKIP() << "it would be made";
  EXPECT_NE(CompareWithReference(MakeImage(8, 8, 0), "there is no such picture"), "");
}

}  // namespace
}  // namespace coppice::editor
