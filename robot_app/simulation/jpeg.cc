#include "robot_app/simulation/jpeg.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace coppice::robot::simulation {

std::vector<std::uint8_t> EncodeJpeg(const Picture& picture, int quality) {
  std::vector<std::uint8_t> bytes;
  const auto append = [](void* target, void* data, int size) {
    const auto* const begin = static_cast<const std::uint8_t*>(data);
    auto& all = *static_cast<std::vector<std::uint8_t>*>(target);
    all.insert(all.end(), begin, begin + size);
  };
  stbi_write_jpg_to_func(append, &bytes, picture.width, picture.height, 3, picture.rgb.data(),
                         quality);
  return bytes;
}

}  // namespace coppice::robot::simulation
