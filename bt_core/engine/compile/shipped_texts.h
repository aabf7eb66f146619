// The files of bt_core/engine/models, which the build puts into the program.
#ifndef COPPICE_BT_CORE_ENGINE_COMPILE_SHIPPED_TEXTS_H_
#define COPPICE_BT_CORE_ENGINE_COMPILE_SHIPPED_TEXTS_H_

#include <vector>

namespace coppice {

struct ShippedText {
  const char* program;  ///< "Nav2"
  const char* xml;
};

const std::vector<ShippedText>& ShippedTexts();

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILE_SHIPPED_TEXTS_H_
