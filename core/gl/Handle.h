// The id of a GL object, owned: one rule of moving for all of core/gl.
//
// What was moved from is empty: id 0, size 0. Assigning frees what was held, at once. Classes made of these
// two and of members that keep the rule have the moves and the destructor that the compiler writes.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace taa::gl {

enum class ObjectKind : std::uint8_t {
  Buffer,
  Framebuffer,
  Program,
  ProgramPipeline,
  Sampler,
  Shader,
  Texture,
  VertexArray
};

/// Does nothing for id 0; else needs the context that the object is of.
void destroyObject(ObjectKind kind, unsigned id) noexcept;
/// Whether the current context has such an object.
bool isObject(ObjectKind kind, unsigned id);
/// For debuggers of GL and its own messages. As much of `label` as every driver takes.
void labelObject(ObjectKind kind, unsigned id, const std::string& label);

template <ObjectKind kind>
class Handle {
 public:
  Handle() = default;
  explicit Handle(unsigned id) : id_(id) {}
  ~Handle() { destroyObject(kind, id_); }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    if (this != &other) destroyObject(kind, std::exchange(id_, std::exchange(other.id_, 0)));
    return *this;
  }
  /// For GL's functions; 0: none.
  operator unsigned() const { return id_; }

 private:
  unsigned id_ = 0;
};

/// A value that describes the object beside it: T() again once it was moved from.
template <class T>
class ResetOnMove {
 public:
  ResetOnMove() = default;
  ResetOnMove(T value) : value_(std::move(value)) {}
  ~ResetOnMove() = default;
  ResetOnMove(ResetOnMove&& other) noexcept : value_(std::exchange(other.value_, T())) {}
  ResetOnMove& operator=(ResetOnMove&& other) noexcept {
    if (this != &other) value_ = std::exchange(other.value_, T());
    return *this;
  }
  operator const T&() const { return value_; }
  const T* operator->() const { return &value_; }

 private:
  T value_{};
};

} // namespace taa::gl
