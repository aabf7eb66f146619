#include "behaviortree_cpp/internal/port_table.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace BT::internal {
namespace {

// A table with a port of each name, whose inputs are slots with the same number.
struct Ports {
  explicit Ports(const std::vector<std::string>& names) : slots(names.size()) {
    std::vector<PortLink> links;
    for (std::size_t k = 0; k < names.size(); ++k) {
      links.push_back({names[k], &slots[k], nullptr, {}});
    }
    table.Fill(std::move(links));
  }
  bool Finds(std::string_view name, std::size_t number) const {
    const PortLink* const found = table.Find(name);
    return found && found->input == &slots[number];
  }
  std::vector<coppice::Slot> slots;
  PortTable table;
};

TEST(PortTable, AnEmptyOneFindsNothing) {
  const PortTable table;
  for (const char* name : {"", "a", "speed", "a_name_of_many_letters"}) {
    EXPECT_FALSE(table.Find(name)) << name;
  }
}

TEST(PortTable, NamesOfEveryLengthAreFound) {
  std::vector<std::string> names;
  for (std::size_t size = 1; size <= 40; ++size) names.push_back(std::string(size, 'a'));
  const Ports ports(names);
  for (std::size_t k = 0; k < names.size(); ++k) EXPECT_TRUE(ports.Finds(names[k], k)) << names[k];
  EXPECT_FALSE(ports.table.Find(std::string(41, 'a')));
}

TEST(PortTable, NamesThatDifferInOneLetterAreToldApart) {
  std::vector<std::string> names;
  for (const std::size_t size : {2, 3, 5, 8, 11, 16, 17, 30}) {
    for (std::size_t k = 0; k < size; ++k) {
      names.push_back(std::string(size, 'x'));
      names.back()[k] = 'y';
    }
  }
  const Ports ports(names);
  for (std::size_t k = 0; k < names.size(); ++k) EXPECT_TRUE(ports.Finds(names[k], k)) << names[k];
}

TEST(PortTable, AnotherNameWithTheSameEndsIsNotFound) {
  const Ports ports({"a_rather_long_name_of_a_port", "abcdefgh", "tick"});
  for (const char* name : {"a_rather_lunk_name_of_a_port", "abcdxfgh", "tack", "tic", "ticks"}) {
    EXPECT_FALSE(ports.table.Find(name)) << name;
  }
}

TEST(PortTable, AClearedOneFindsNothing) {
  Ports ports({"speed"});
  ports.table.Clear();
  EXPECT_FALSE(ports.table.Find("speed"));
}

}  // namespace
}  // namespace BT::internal
