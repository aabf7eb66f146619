// That the schema says the right things; that it is one is for xmllint to say, in
// cli/nodes_test.cc.
#include "bt_core/engine/compile/schema.h"

#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

class SchemaTest : public testing::Test {
 protected:
  bool Has(const std::string& part) const { return xsd_.find(part) != std::string::npos; }
  const std::string xsd_ = WriteSchema(*TestRegistry());
};

TEST_F(SchemaTest, HasAnElementForEveryNode) {
  Diagnostics diagnostics;
  const auto document = Document::FromText(xsd_, "t.xsd", diagnostics);
  ASSERT_TRUE(document) << diagnostics.ToString();
  std::size_t elements = 0;
  for (const Element& element : document->elements()) {
    elements += element.parent == 0 && element.tag == "xs:element";
  }
  // root, the other four generic forms, and SubTree, which is a node type, too
  EXPECT_EQ(elements, TestRegistry()->entries().size() + 5);
}

TEST_F(SchemaTest, PortsHaveTypesAndTellWhetherTheyAreNeeded) {
  EXPECT_TRUE(Has(R"(<xs:attribute name="goal" type="number_or_key" use="required">)"
                  "<xs:annotation><xs:documentation>where to [m]<"));
  EXPECT_TRUE(Has(R"(<xs:attribute name="tries" type="whole_number_or_key">)"));
  EXPECT_TRUE(Has(R"(<xs:attribute name="distance" type="key">)"));
}

TEST_F(SchemaTest, EnumsListTheirChoices) {
  EXPECT_TRUE(Has(R"(<xs:enumeration value="SUCCESS"/><xs:enumeration value="FAILURE"/>)"));
}

TEST_F(SchemaTest, TheNumberOfChildrenIsThere) {
  EXPECT_TRUE(Has(R"(<xs:group ref="node" minOccurs="1" maxOccurs="unbounded"/>)"));
  EXPECT_TRUE(Has(R"(<xs:group ref="node" minOccurs="1" maxOccurs="1"/>)"));
  EXPECT_TRUE(Has(R"(<xs:group ref="node" minOccurs="2" maxOccurs="3"/>)"));
}

TEST_F(SchemaTest, EveryNodeMayHaveGuards) {
  for (const std::string_view guard : kGuardAttributes) {
    EXPECT_TRUE(Has("<xs:attribute name=\"" + std::string(guard) + R"(" type="xs:string"/>)"));
  }
}

}  // namespace
}  // namespace coppice
