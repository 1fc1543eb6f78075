// taa_capture.h as C++, with its functions in this file, and once more without them, as other files include
// it.
#define TAA_CAPTURE_IMPLEMENTATION
#include "taa_capture.h"

static_assert(__cplusplus == WANTED_STANDARD, "compiled as the C++ that it is a test for");

int main() {
  taa_capture* capture = nullptr;
  taa_capture_desc desc = {};
  const bool refuses = taa_capture_open(&capture, &desc) == TAA_ERROR_ARGUMENT && capture == nullptr;
  return refuses && taa_capture_close(capture) == TAA_OK ? 0 : 1;
}
