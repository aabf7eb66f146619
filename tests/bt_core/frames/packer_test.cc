#include "bt_core/frames/packer.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace coppice {
namespace {

constexpr std::size_t kNoLimit = 1 << 30;

Bytes FromText(const std::string& text) { return {text.begin(), text.end()}; }

Bytes Pack(Packer& packer, const std::string& text) {
  Bytes piece;
  packer.Pack(FromText(text), piece);
  return piece;
}

std::string Unpack(Unpacker& unpacker, const Bytes& piece, std::size_t limit = kNoLimit) {
  Bytes out;
  if (!unpacker.Unpack(piece.data(), piece.size(), limit, out)) return "(damaged)";
  return {out.begin(), out.end()};
}

TEST(Packer, EachPieceCanBeUnpackedAtOnce) {
  Packer packer;
  Unpacker unpacker;
  for (int i = 0; i < 100; ++i) {
    const std::string text = "text " + std::to_string(i);
    EXPECT_EQ(Unpack(unpacker, Pack(packer, text)), text);
  }
}

TEST(Packer, APieceIsShortIfItIsLikeThoseBeforeIt) {
  Packer packer;
  std::mt19937 random(1);
  std::string text;
  for (int i = 0; i < 5000; ++i) text += static_cast<char>(random());
  EXPECT_GT(Pack(packer, text).size(), 5000u);
  EXPECT_LT(Pack(packer, text).size(), 40u);
}

TEST(Packer, BeginsANewStreamWhenItIsTold) {
  Packer packer;
  Pack(packer, "one");
  packer.Restart();
  const Bytes piece = Pack(packer, "two");
  Unpacker unpacker;
  EXPECT_EQ(Unpack(unpacker, piece), "two");
  packer.Restart();
  unpacker.Restart();
  EXPECT_EQ(Unpack(unpacker, Pack(packer, "three")), "three");
}

TEST(Packer, TakesAnyNumberOfBytes) {
  Packer packer;
  Unpacker unpacker;
  for (const std::size_t size : {0u, 1u, 65536u, 65537u, 3000000u}) {
    std::string text(size, 'x');
    for (std::size_t i = 0; i < size; i += 7) text[i] = static_cast<char>(i * i >> 3);
    EXPECT_EQ(Unpack(unpacker, Pack(packer, text)), text) << size;
  }
}

TEST(Unpacker, StopsAtTheLimit) {
  Packer packer;
  const Bytes piece = Pack(packer, std::string(10000000, 'x'));
  EXPECT_LT(piece.size(), 10000u);
  Unpacker unpacker;
  EXPECT_EQ(Unpack(unpacker, piece, 100000), "(damaged)");
}

TEST(Unpacker, NoticesNonsense) {
  Unpacker unpacker;
  EXPECT_EQ(Unpack(unpacker, FromText("no such stream, but long enough")), "(damaged)");
}

}  // namespace
}  // namespace coppice
