#include "editor/theme/imgui_style.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

class ImGuiStyleTest : public testing::Test {
 protected:
  ImGuiStyleTest() : context_(ImGui::CreateContext()) { ImGui::SetCurrentContext(context_); }
  ~ImGuiStyleTest() override { ImGui::DestroyContext(context_); }
  ImGuiContext* context_;
};

TEST_F(ImGuiStyleTest, TakesTheColoursOfThePalette) {
  const Palette& light = GetPalette(PaletteName::kLight);
  ApplyImGuiStyle(light, 1);
  EXPECT_EQ(ImGui::GetColorU32(ImGuiCol_PopupBg), light.panel);
  const float width = ImGui::GetStyle().ScrollbarSize;
  ApplyImGuiStyle(light, 2);
  EXPECT_EQ(ImGui::GetStyle().ScrollbarSize, 2 * width) << "not four times: scaled from scratch";
}

TEST_F(ImGuiStyleTest, HandsKeysOnWithTheirModifiers) {
  ImGuiIO& io = ImGui::GetIO();
  MapKeys(io);
  ApplyKey(io, {kKeyBackspace, true, kCtrl});
  EXPECT_TRUE(io.KeysDown[io.KeyMap[ImGuiKey_Backspace]]);
  EXPECT_TRUE(io.KeyCtrl);
  ApplyKey(io, {kKeyBackspace, false, kNoModifier});
  EXPECT_FALSE(io.KeysDown[kKeyBackspace]);
  EXPECT_FALSE(io.KeyCtrl);
  ApplyKey(io, {341, true, kNoModifier});
  EXPECT_TRUE(io.KeyCtrl);
  ApplyKey(io, {341, false, kCtrl});
  EXPECT_FALSE(io.KeyCtrl) << "X11 still names the modifier that is released";
  ApplyKey(io, {-1, true, kNoModifier});  // GLFW's unknown key
}

}  // namespace
}  // namespace coppice::editor
