#include "robot_app/common/compressed_picture.h"

#include <png.h>
#include <turbojpeg.h>
#include <zlib.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <memory>
#include <string>
#include <type_traits>

namespace coppice::robot {
namespace {

// compressed_depth_image_transport: a format (0: not given) and two factors for inverse depth.
constexpr std::size_t kDepthHeader = 12;
constexpr int kFast = 1;  // of zlib's levels

struct CloseTurbo {
  void operator()(void* handle) const { tjDestroy(handle); }
};
using Turbo = std::unique_ptr<std::remove_pointer_t<tjhandle>, CloseTurbo>;

bool IsSizeFine(std::int64_t width, std::int64_t height) {
  return width > 0 && height > 0 && width * height <= kMostPixels;
}

Problem TooLarge(std::int64_t width, std::int64_t height) {
  return {"a picture of " + std::to_string(width) + " x " + std::to_string(height) +
          " pixels, expected at most " + std::to_string(kMostPixels)};
}

// libpng tells errors by a long jump, so what has destructors lives outside of the functions that
// it can jump out of.
struct PngWriter {
  std::vector<std::uint8_t> bytes;
  png_structp png = nullptr;
  png_infop info = nullptr;

  ~PngWriter() { png_destroy_write_struct(&png, &info); }

  static void Append(png_structp png, png_bytep data, png_size_t size) {
    auto& bytes = static_cast<PngWriter*>(png_get_io_ptr(png))->bytes;
    bytes.insert(bytes.end(), data, data + size);
  }
  static void Flush(png_structp) {}
};

struct PngReader {
  const std::uint8_t* next = nullptr;
  const std::uint8_t* end = nullptr;
  std::string problem;
  png_structp png = nullptr;
  png_infop info = nullptr;

  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }

  static void Read(png_structp png, png_bytep data, png_size_t size) {
    auto& reader = *static_cast<PngReader*>(png_get_io_ptr(png));
    if (size > static_cast<std::size_t>(reader.end - reader.next)) png_error(png, "it ends early");
    std::memcpy(data, reader.next, size);
    reader.next += size;
  }
  static void Fail(png_structp png, png_const_charp text) {
    static_cast<PngReader*>(png_get_error_ptr(png))->problem = text;
    longjmp(png_jmpbuf(png), 1);
  }
  static void Warn(png_structp, png_const_charp) {}
};

bool WritePng(PngWriter& writer, const DepthPicture& picture) {
  if (setjmp(png_jmpbuf(writer.png)) != 0) return false;
  png_set_write_fn(writer.png, &writer, &PngWriter::Append, &PngWriter::Flush);
  png_set_compression_level(writer.png, kFast);
  png_set_compression_strategy(writer.png, Z_RLE);
  png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
  png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(picture.width),
               static_cast<png_uint_32>(picture.height), 16, PNG_COLOR_TYPE_GRAY,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(writer.png, writer.info);
  png_set_swap(writer.png);
  for (int row = 0; row < picture.height; ++row) {
    png_write_row(writer.png,
                  reinterpret_cast<png_const_bytep>(
                      &picture.millimetres[static_cast<std::size_t>(row) * picture.width]));
  }
  png_write_end(writer.png, nullptr);
  return true;
}

bool ReadHeader(PngReader& reader) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  png_set_read_fn(reader.png, &reader, &PngReader::Read);
  png_read_info(reader.png, reader.info);
  return true;
}

bool ReadRows(PngReader& reader, std::vector<png_bytep>& rows) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  png_set_swap(reader.png);
  png_read_image(reader.png, rows.data());
  return true;
}

std::vector<png_bytep> RowsOf(DepthPicture& picture) {
  std::vector<png_bytep> rows;
  for (int row = 0; row < picture.height; ++row) {
    rows.push_back(reinterpret_cast<png_bytep>(
        &picture.millimetres[static_cast<std::size_t>(row) * picture.width]));
  }
  return rows;
}

}  // namespace

std::vector<std::uint8_t> EncodeJpeg(const Picture& picture, int quality) {
  if (!IsSizeFine(picture.width, picture.height)) return {};
  const Turbo turbo(tjInitCompress());
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  const int status = tjCompress2(turbo.get(), picture.rgb.data(), picture.width, 0, picture.height,
                                 TJPF_RGB, &bytes, &size, TJSAMP_420, quality, 0);
  std::vector<std::uint8_t> encoded;
  if (status == 0) encoded.assign(bytes, bytes + size);
  tjFree(bytes);
  return encoded;
}

Expected<Picture> DecodeJpeg(const std::vector<std::uint8_t>& bytes) {
  const Turbo turbo(tjInitDecompress());
  int width = 0, height = 0, sampling = 0, colours = 0;
  if (tjDecompressHeader3(turbo.get(), bytes.data(), bytes.size(), &width, &height, &sampling,
                          &colours) != 0) {
    return Problem{std::string("no JPEG: ") + tjGetErrorStr2(turbo.get())};
  }
  if (!IsSizeFine(width, height)) return TooLarge(width, height);
  Picture picture(width, height);
  // A few bytes can ask for one more look at the whole picture, without end.
  const int status =
      tjDecompress2(turbo.get(), bytes.data(), bytes.size(), picture.rgb.data(), width, 0, height,
                    TJPF_RGB, TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS);
  if (status != 0) return Problem{std::string("a damaged JPEG: ") + tjGetErrorStr2(turbo.get())};
  return picture;
}

std::vector<std::uint8_t> EncodeDepth(const DepthPicture& picture) {
  if (!IsSizeFine(picture.width, picture.height)) return {};
  PngWriter writer;
  writer.bytes.assign(kDepthHeader, 0);
  writer.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  writer.info = png_create_info_struct(writer.png);
  if (!WritePng(writer, picture)) return {};
  return std::move(writer.bytes);
}

Expected<DepthPicture> DecodeDepth(const std::vector<std::uint8_t>& bytes) {
  if (bytes.size() <= kDepthHeader) return Problem{"no depth picture: it ends early"};
  PngReader reader;
  reader.next = bytes.data() + kDepthHeader;
  reader.end = bytes.data() + bytes.size();
  reader.png =
      png_create_read_struct(PNG_LIBPNG_VER_STRING, &reader, &PngReader::Fail, &PngReader::Warn);
  reader.info = png_create_info_struct(reader.png);
  if (!ReadHeader(reader)) return Problem{"no PNG after twelve bytes: " + reader.problem};
  const std::int64_t width = png_get_image_width(reader.png, reader.info);
  const std::int64_t height = png_get_image_height(reader.png, reader.info);
  if (!IsSizeFine(width, height)) return TooLarge(width, height);
  if (png_get_bit_depth(reader.png, reader.info) != 16 ||
      png_get_color_type(reader.png, reader.info) != PNG_COLOR_TYPE_GRAY ||
      png_get_interlace_type(reader.png, reader.info) != PNG_INTERLACE_NONE) {
    return Problem{"a PNG of another kind, expected one channel of 16 bits, not interlaced"};
  }
  DepthPicture picture(static_cast<int>(width), static_cast<int>(height));
  std::vector<png_bytep> rows = RowsOf(picture);
  if (!ReadRows(reader, rows)) return Problem{"a damaged PNG: " + reader.problem};
  return picture;
}

}  // namespace coppice::robot
