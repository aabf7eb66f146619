#include "robot_app/expression/face_painter.h"

#include <gtest/gtest.h>

#include "robot_app/expression/face_texts.h"

namespace coppice::robot::expression {
namespace {

const Colour kBlack{0, 0, 0}, kRed{255, 0, 0};

FaceFrame With(ShapeKind kind, const std::array<double, 6>& numbers) {
  FaceFrame frame;
  frame.eyes = {{kind, numbers, kRed}};
  return frame;
}

TEST(FacePainter, MirrorsTheLeftEye) {
  const Picture face = PaintFace(With(ShapeKind::kDisc, {8, 0, 2}));
  EXPECT_EQ(face.at(7, 15), kRed);
  EXPECT_EQ(face.at(56, 15), kRed);
  EXPECT_EQ(face.at(24, 15), kBlack);
}

TEST(FacePainter, AnArcBelongsToTheSameSideOfBothEyes) {
  const Picture face = PaintFace(With(ShapeKind::kArc, {0, 0, 10, 3, -45, 45}));
  EXPECT_EQ(face.at(5, 15), kRed) << "away from the nose";
  EXPECT_EQ(face.at(25, 15), kBlack);
  EXPECT_EQ(face.at(58, 15), kRed);
}

TEST(FacePainter, LooksToOneSideWithBothEyes) {
  FaceFrame frame = With(ShapeKind::kDisc, {0, 0, 2});
  frame.look = {5, 0};
  const Picture face = PaintFace(frame);
  EXPECT_EQ(face.at(20, 15), kRed);
  EXPECT_EQ(face.at(52, 15), kRed);
}

TEST(FacePainter, CutsOffWhatLiesOutside) {
  const Picture face = PaintFace(With(ShapeKind::kLine, {-1000, -1000, 1000, 1000, 1000}));
  EXPECT_EQ(face.rgb.size(), 3u * kFaceWidth * kFaceHeight);
}

TEST(FacePainter, ATerminalShowsTwoRowsInALine) {
  Picture two(1, 2);
  two.rgb = {1, 2, 3, 4, 5, 6};
  EXPECT_EQ(TerminalText(two), "\x1b[38;2;1;2;3m\x1b[48;2;4;5;6m▀\x1b[0m\n");
}

}  // namespace
}  // namespace coppice::robot::expression
