#include "editor/live/key_writes.h"

#include <gtest/gtest.h>

#include "bt_core/data/value_bytes.h"

namespace coppice::editor {
namespace {

template <class T>
std::string Bytes(T value) {
  Value of;
  of.Set(std::move(value));
  std::string bytes;
  AppendValueBytes(of, bytes);
  return bytes;
}

// Of a key that only scripts use, or of a port's.
Expected<LiveCommand> Write(const std::string& present, const std::string& text,
                            const std::string& type = "any") {
  TreeDescription tree;
  tree.main_tree = "Main";
  tree.slots.push_back({"Main", "key", type, true});
  return WriteOf(tree, SlotIndex{0}, present, text);
}

TEST(KeyWrites, AFractionStaysOneThoughAWholeNumberIsTyped) {
  EXPECT_EQ(Write(Bytes(0.5), "1")->value, "1.0");
  EXPECT_TRUE(Write(Bytes(0.5), "1")->is_json);
}

TEST(KeyWrites, ATextOfDigitsStaysAText) {
  EXPECT_EQ(Write(Bytes(std::string("kitchen")), "12")->value, "\"12\"");
}

TEST(KeyWrites, ATruthStaysOne) {
  EXPECT_EQ(Write(Bytes(true), "false")->value, "false");
  EXPECT_EQ(Write(Bytes(true), "no").problem(), "\"no\" is neither true nor false");
}

TEST(KeyWrites, AWholeNumberTakesNoFraction) {
  EXPECT_EQ(Write(Bytes(std::int64_t{3}), "-4")->value, "-4");
  EXPECT_EQ(Write(Bytes(std::int64_t{3}), "2.5").problem(), "\"2.5\" is not a whole number");
}

TEST(KeyWrites, AKeyOfAPortIsWrittenAsInTheXml) {
  EXPECT_EQ(Write(Bytes(0.5), "1", "double")->value, "1");
  EXPECT_FALSE(Write(Bytes(0.5), "1", "double")->is_json);
}

TEST(KeyWrites, AKeyWithoutAValueIsWrittenAsInTheXml) { EXPECT_FALSE(Write("", "12")->is_json); }

}  // namespace
}  // namespace coppice::editor
