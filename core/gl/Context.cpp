#include "core/gl/Context.h"

#include "core/base/Error.h"
#include "core/base/FreeMemory.h"
#include "core/base/Say.h"
#include "core/gl/DriverRefusal.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <mutex>
#include <utility>

namespace taa::gl {

struct Context::Handles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  std::mutex mutex; // drivers may call back from threads of their own
  std::vector<std::string> messages;
};

namespace {

[[noreturn]] void refuse(const StartFailure& failure) {
  throw Error(refusal(failure, processEnvironment()));
}

bool initialize(EGLDisplay display) {
  EGLint major = 0, minor = 0;
  return display != EGL_NO_DISPLAY && eglInitialize(display, &major, &minor) == EGL_TRUE;
}

/// What EGL can do before a display is open; nothing of the kind where it knows no driver. libepoxy ends the
/// process when a function is called that no driver has.
bool hasClientExtension(const char* name) {
  const char* all = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  return all && (" " + std::string(all) + " ").find(" " + std::string(name) + " ") != std::string::npos;
}

EGLDisplay openDevice() {
  if (!hasClientExtension("EGL_EXT_device_base") && !hasClientExtension("EGL_EXT_device_enumeration"))
    return EGL_NO_DISPLAY;
  EGLDeviceEXT devices[16] = {};
  EGLint count = 0;
  if (!eglQueryDevicesEXT(16, devices, &count)) count = 0;
  for (EGLint index = 0; index < count; ++index) {
    const char* extensions = eglQueryDeviceStringEXT(devices[index], EGL_EXTENSIONS);
    if (extensions && std::string(extensions).find("EGL_MESA_device_software") != std::string::npos) continue;
    EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[index], nullptr);
    if (initialize(display)) return display;
  }
  return EGL_NO_DISPLAY;
}

// A GPU when one can be opened; else Mesa's surfaceless platform, which rasterizes in software. libepoxy
// knows no EGL version before a display exists, so the EXT entry points are the ones to ask for.
EGLDisplay openDisplay() {
  if (EGLDisplay display = openDevice(); display != EGL_NO_DISPLAY) return display;
  if (!hasClientExtension("EGL_MESA_platform_surfaceless")) refuse({StartStep::Library});
  EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (!initialize(display)) refuse({StartStep::Display});
  return display;
}

EGLContext makeContext(EGLDisplay display, EGLint major, EGLint minor) {
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                               major,
                               EGL_CONTEXT_MINOR_VERSION,
                               minor,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                               EGL_CONTEXT_OPENGL_DEBUG,
                               EGL_TRUE,
                               EGL_NONE};
  return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
}

std::string text(GLenum name) {
  const auto* value = reinterpret_cast<const char*>(glGetString(name));
  return value ? value : "";
}

Driver describeDriver() {
  Driver driver{text(GL_VENDOR), text(GL_RENDERER), text(GL_VERSION)};
  const auto runsOn = [&](const char* name) { return driver.renderer.find(name) != std::string::npos; };
  driver.isSoftware = runsOn("llvmpipe") || runsOn("softpipe");
  driver.isExact = driver.isSoftware && !runsOn("zink");
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &driver.maxTextureSize);
  return driver;
}

/// Ends a context that is of no use, once it has said what it is.
Driver describeAndDestroy(EGLDisplay display, EGLContext context) {
  Driver driver;
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) driver = describeDriver();
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display, context);
  return driver;
}

/// Asked for the oldest core profile, or for any, drivers give the newest there is.
[[noreturn]] void refuseVersion(EGLDisplay display) {
  constexpr EGLint kAny[] = {EGL_NONE};
  EGLContext context = makeContext(display, 3, 2);
  if (context == EGL_NO_CONTEXT) context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAny);
  if (context == EGL_NO_CONTEXT) refuse({StartStep::Context});
  const Driver driver = describeAndDestroy(display, context);
  refuse({StartStep::Context, driver.renderer, driver.version});
}

} // namespace

std::optional<std::string> knownFault(const std::string& renderer, const std::string& version) {
  if (!isKnownToCrash(renderer, version)) return std::nullopt;
  return refusal({StartStep::Crash, renderer, version}, processEnvironment());
}

Context::Context() : handles_(std::make_unique<Handles>()) {
  handles_->display = openDisplay();
  if (!eglBindAPI(EGL_OPENGL_API)) refuse({StartStep::DesktopGl});
  handles_->context = makeContext(handles_->display, 4, 5);
  if (handles_->context == EGL_NO_CONTEXT) refuseVersion(handles_->display);
  if (!eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles_->context)) {
    eglDestroyContext(handles_->display, handles_->context);
    refuse({StartStep::Surfaceless});
  }
  driver_ = describeDriver();
  if (const auto fault = knownFault(driver_.renderer, driver_.version)) {
    describeAndDestroy(handles_->display, handles_->context);
    throw Error(*fault);
  }
  glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDisable(GL_DITHER);
  glEnable(GL_DEBUG_OUTPUT);
  const auto report = [](GLenum source, GLenum type, GLuint, GLenum severity, GLsizei length,
                         const GLchar* message, const void* user) {
    // What the compiler says is in the Error of the program that does not compile.
    if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
    if (severity != GL_DEBUG_SEVERITY_HIGH && type != GL_DEBUG_TYPE_ERROR) return;
    auto* handles = static_cast<Handles*>(const_cast<void*>(user));
    const std::lock_guard lock(handles->mutex);
    handles->messages.emplace_back(message, static_cast<std::size_t>(length));
  };
  glDebugMessageCallback(report, handles_.get());
}

Context::~Context() {
  glDebugMessageCallback(nullptr, nullptr);
  eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(handles_->display, handles_->context);
  // The display is shared by the process and stays open: closing it would end other contexts.
}

void Context::makeCurrent() {
  eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles_->context);
}

std::vector<std::string> Context::takeMessages() {
  const std::lock_guard lock(handles_->mutex);
  return std::exchange(handles_->messages, {});
}

void finish() {
  glFinish();
}

std::optional<std::size_t> availableMemory(const Driver& driver) {
  if (driver.isSoftware) return freeMemory();
  // Both extensions answer in KiB; the second with four numbers, the first of which is the sum.
  GLint kibibytes[4] = {0, 0, 0, 0};
  if (epoxy_has_gl_extension("GL_NVX_gpu_memory_info"))
    glGetIntegerv(GL_GPU_MEMORY_INFO_CURRENT_AVAILABLE_VIDMEM_NVX, kibibytes);
  else if (epoxy_has_gl_extension("GL_ATI_meminfo"))
    glGetIntegerv(GL_TEXTURE_FREE_MEMORY_ATI, kibibytes);
  if (kibibytes[0] <= 0) return std::nullopt;
  return static_cast<std::size_t>(kibibytes[0]) * 1024;
}

namespace {

GLenum takeWorstError() {
  GLenum worst = GL_NO_ERROR;
  for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError())
    if (worst != GL_OUT_OF_MEMORY) worst = error;
  return worst;
}

} // namespace

void checkErrors(const std::string& what) {
  const GLenum worst = takeWorstError();
  if (worst == GL_OUT_OF_MEMORY) throwOutOfMemory(what);
  if (worst != GL_NO_ERROR) throw Error(say<"%1: GL reports error %2">(what, worst));
}

void checkAllocated(const std::string& label, const std::string& what) {
  const GLenum worst = takeWorstError();
  if (worst == GL_OUT_OF_MEMORY) throwOutOfMemory(what);
  if (worst != GL_NO_ERROR) throw Error(say<"cannot make %1: GL reports error %2">(label, worst));
}

void throwOutOfMemory(const std::string& what) {
  throw Error(say<"%1: the GL driver is out of memory; use a smaller size or fewer lanes">(what));
}

} // namespace taa::gl
