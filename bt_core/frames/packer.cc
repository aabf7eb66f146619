#include "bt_core/frames/packer.h"

#include <zstd.h>

#include <algorithm>
#include <new>
#include <utility>

namespace coppice {
namespace {

constexpr int kLevel = 3;
constexpr int kWindowBits = 18;  // as much as lies between two states, by default
constexpr int kMaxWindowBits = 20;
constexpr std::size_t kStep = 64 << 10;
constexpr std::size_t kSmallStep = 256;

}  // namespace

Packer::Packer() : context_(ZSTD_createCCtx()) {
  if (!context_) throw std::bad_alloc();
  ZSTD_CCtx_setParameter(context_, ZSTD_c_compressionLevel, kLevel);
  ZSTD_CCtx_setParameter(context_, ZSTD_c_windowLog, kWindowBits);
}

Packer::~Packer() { ZSTD_freeCCtx(context_); }

void Packer::Restart() { ZSTD_CCtx_reset(context_, ZSTD_reset_session_only); }

void Packer::Pack(const Bytes& raw, Bytes& out) {
  ZSTD_inBuffer input{raw.data(), raw.size(), 0};
  const std::size_t step = std::clamp(raw.size() / 2, kSmallStep, kStep);  // often enough
  std::size_t left = 1;
  while (left != 0) {
    const std::size_t before = out.size();
    out.resize(before + step);
    ZSTD_outBuffer output{out.data() + before, step, 0};
    left = ZSTD_compressStream2(context_, &output, &input, ZSTD_e_flush);
    if (ZSTD_isError(left)) throw std::bad_alloc();  // nothing else can go wrong here
    out.resize(before + output.pos);
  }
}

Unpacker::Unpacker() : context_(ZSTD_createDCtx()) {
  if (!context_) throw std::bad_alloc();
  ZSTD_DCtx_setParameter(context_, ZSTD_d_windowLogMax, kMaxWindowBits);
}

Unpacker::~Unpacker() { ZSTD_freeDCtx(context_); }

Unpacker::Unpacker(Unpacker&& other) noexcept : context_(std::exchange(other.context_, nullptr)) {}

Unpacker& Unpacker::operator=(Unpacker&& other) noexcept {
  std::swap(context_, other.context_);
  return *this;
}

void Unpacker::Restart() { ZSTD_DCtx_reset(context_, ZSTD_reset_session_only); }

bool Unpacker::Unpack(const std::uint8_t* data, std::size_t size, std::size_t limit, Bytes& out) {
  ZSTD_inBuffer input{data, size, 0};
  const std::size_t begin = out.size();
  bool is_full = true;  // there may be more than the last step had room for
  while (input.pos < input.size || is_full) {
    const std::size_t before = out.size();
    if (before - begin > limit) return false;
    out.resize(before + kStep);
    ZSTD_outBuffer output{out.data() + before, kStep, 0};
    const std::size_t left = ZSTD_decompressStream(context_, &output, &input);
    out.resize(before + output.pos);
    if (ZSTD_isError(left)) return false;
    if (left == 0) return false;  // a stream never ends
    is_full = output.pos == kStep;
  }
  return out.size() - begin <= limit;
}

}  // namespace coppice
