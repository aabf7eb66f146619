#include "editor/commands/menus.h"

#include <gmock/gmock.h>

#include "editor/commands/menu_tables.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

constexpr const char* kOfThings[] = {menu::kNode, menu::kLine, menu::kCanvas, menu::kRow,
                                     menu::kKey,  menu::kLane, menu::kTree,   menu::kTab};

TEST(Menus, HoldOnlyCommandsThatThereAre) {
  Driver driver;
  const auto check = [&](std::string_view menu) {
    for (const bool in_run : {false, true}) {
      for (const std::string_view id : CommandsOf(menu, in_run)) {
        EXPECT_TRUE(id.empty() || driver.editor.state().commands.Find(id)) << menu << ": " << id;
      }
    }
  };
  for (const char* menu : kOfThings) check(menu);
  for (const char* menu : {"file", "edit", "tree", "view", "tiles", "robot", "run", "simulate"}) {
    EXPECT_FALSE(CommandsOf(menu, false).empty()) << menu;
    check(menu);
  }
}

TEST(Menus, HaveLinesOnlyBetweenEntries) {
  for (const char* menu : kOfThings) {
    const auto commands = CommandsOf(menu, false);
    ASSERT_FALSE(commands.empty()) << menu;
    EXPECT_FALSE(commands.front().empty()) << menu;
    EXPECT_FALSE(commands.back().empty()) << menu;
    for (std::size_t i = 1; i < commands.size(); ++i) {
      EXPECT_FALSE(commands[i].empty() && commands[i - 1].empty()) << menu;
    }
  }
}

TEST(Menus, SayWhyAnEntryCannotBeDone) {
  Driver driver;
  for (const MenuItem& item : ItemsOf(driver.editor.state(), "edit")) {
    if (item.path == "menu/edit.delete") {
      EXPECT_EQ(item.why_not, "no file is open");
    }
    if (item.path == "menu/edit.undo") {
      EXPECT_EQ(item.why_not, "nothing has been done yet");
    }
  }
}

TEST(Menus, ListRecentFilesAndThoseThatAreGoneAreGrey) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.state().recent.files = {file.path(), "/nowhere/gone.xml"};
  const auto items = ItemsOf(driver.editor.state(), "file.recent");
  ASSERT_EQ(items.size(), 2U);
  EXPECT_EQ(items[0].why_not, "");
  EXPECT_EQ(items[1].why_not, "this file no longer exists");
}

TEST(Menus, AnUnknownNameHasNoEntries) {
  Driver driver;
  EXPECT_TRUE(ItemsOf(driver.editor.state(), "sandwiches").empty());
}

TEST(Menus, ALetterGoesToTheNextEntryThatBeginsWithIt) {
  Driver driver;
  EditorState& state = driver.editor.state();
  OpenMenu(state, "help", {});
  PressInMenu(state, {'K'});
  const auto items = ItemsOf(state, "help");
  ASSERT_GE(state.menu.open.back().choice, 0);
  EXPECT_EQ(items[static_cast<std::size_t>(state.menu.open.back().choice)].path, "menu/help.keys");
}

}  // namespace
}  // namespace coppice::editor
