#include "bt_core/model/element_path.h"

#include "tests/bt_core/model/edited.h"

namespace coppice {
namespace {

const char* const kText =
    "<root><BehaviorTree ID='Main'><Sequence name='go [1]'><Action ID='Drive' x='1'/>"
    "<Drive x='2'/><Wait name='Drive' x='3'/></Sequence></BehaviorTree></root>";

std::string Find(std::string_view path) {
  const Document document = Parsed(kText);
  Diagnostics diagnostics;
  const ElementIndex index = FindByPath(document, path, diagnostics);
  if (index == kNoElement) return diagnostics.ToString();
  EXPECT_FALSE(diagnostics.has_errors());
  const Element& element = document.element(index);
  return std::string(element.tag) + std::string(document.AttributeValue(element, "x"));
}

TEST(ElementPath, StepsAreNamesOrTypes) {
  EXPECT_EQ(Find(""), "root");
  EXPECT_EQ(Find("Main"), "BehaviorTree");
  EXPECT_EQ(Find("Main/Sequence/Drive"), "Action1");
  EXPECT_EQ(Find("Main/Sequence/Wait"), "Wait3");
}

TEST(ElementPath, NumbersChooseAmongThoseThatFit) {
  EXPECT_EQ(Find("Main/Sequence/Drive[1]"), "Action1");
  EXPECT_EQ(Find("Main/Sequence/Drive[2]"), "Drive2");
  EXPECT_EQ(Find("Main/Sequence/Drive[3]"), "Wait3");
}

TEST(ElementPath, WhatFitsNothingIsNamed) {
  EXPECT_EQ(Find("Main/Sequence/Drive[4]"), "t.xml:1:31: error: no \"Drive[4]\" in <Sequence>\n");
  EXPECT_EQ(Find("Mian/Sequence"),
            "t.xml:1:1: error: no \"Mian\" in <root> (did you mean \"Main\"?)\n");
  EXPECT_EQ(Find("Main/Sequence/Drive[x]").substr(0, 30), "t.xml:1:31: error: no \"Drive[x");
  EXPECT_EQ(Find("Main/Sequence/Drive[0]").substr(0, 30), "t.xml:1:31: error: no \"Drive[0");
}

}  // namespace
}  // namespace coppice
