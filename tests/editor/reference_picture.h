// Pictures that the editor is compared with: tests/editor/reference/NAME.png, half as large as what
// the window shows. The rasteriser gives the same picture everywhere but for the fonts of the
// computer, so a little may differ.
//
// After a change that is meant to be seen, look at the new pictures and keep them:
//
//   COPPICE_UPDATE_REFERENCE=1 build/tests/bin/editor_test --gtest_filter='*Picture*:*Story*'
#ifndef COPPICE_TESTS_EDITOR_REFERENCE_PICTURE_H_
#define COPPICE_TESTS_EDITOR_REFERENCE_PICTURE_H_

#include <optional>
#include <string>

#include "editor/render/image.h"

namespace coppice::editor {

/// Half as wide and as high; every pixel is the mean of four. Colours are rounded, so that the file
/// is small.
Image HalfSize(const Image& image);

/// The part of the pixels that differ visibly; 1 if the sizes differ.
double DifferentPart(const Image& a, const Image& b);

/// Nothing if the file cannot be read.
std::optional<Image> ReadPng(const std::string& path);

/// Empty if what is shown is like the reference of that name, else a text for people; what is shown
/// is then in the folder of temporary files. With COPPICE_UPDATE_REFERENCE it becomes the
/// reference.
std::string CompareWithReference(const Image& shown, const std::string& name);

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_REFERENCE_PICTURE_H_
