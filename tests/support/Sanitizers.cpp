// Part of every sanitized program: what to overlook in other people's libraries, so that only our own
// mistakes are reported.

extern "C" {

/// Names of the libraries, as LeakSanitizer matches them against the stack of an allocation.
__attribute__((visibility("default"))) const char* __lsan_default_suppressions() {
  return "leak:libdbus-1\nleak:libGLX_mesa\nleak:libEGL_mesa\nleak:swrast_dri\nleak:libgallium\n"
         "leak:libfontconfig\nleak:libglib-2.0\nleak:libLLVM\n";
}

__attribute__((visibility("default"))) const char* __lsan_default_options() {
  return "print_suppressions=0";
}

/// Mesa, LLVM and OpenImageIO are not built with ThreadSanitizer, so it would not see how they lock.
__attribute__((visibility("default"))) const char* __tsan_default_options() {
  return "ignore_noninstrumented_modules=1";
}

/// Libraries stay loaded, for a leak can be matched by name only while its library is.
__attribute__((visibility("default"))) int dlclose(void*) noexcept {
  return 0;
}
}
