// taa_capture.h: writes what a frame of your engine is made of, so that TAA Inspector can open it.
//
// One file for C99 and C++, no graphics API, nothing but the C library. Include it wherever you need it; in
// ONE source file define TAA_CAPTURE_IMPLEMENTATION before, so that <stdio.h> and the code are there alone:
//
//   #define TAA_CAPTURE_IMPLEMENTATION
//   #include "taa_capture.h"
//
//   const char* conventions[] = {"motion.unit=uv", "depth.reversed=true", NULL}; // what differs from "like"
//   taa_capture_desc desc = {0}; // C++: = {}
//   desc.folder = "capture";  desc.width = 1920;  desc.height = 1080;
//   desc.like = "unity";      desc.conventions = conventions;  desc.frames_per_second = 60;
//   taa_capture* capture = NULL;
//   int status = taa_capture_open(&capture, &desc);
//   for (int i = 0; i < 32 && !status; ++i) { // camera still, turning, moving, an object moving: 8 each
//     taa_capture_frame frame = {0};
//     frame.number = i;  frame.jitter[0] = jitter_x;  frame.jitter[1] = jitter_y;
//     frame.view = view; frame.projection = projection; frame.cut = i == 0;
//     status = taa_capture_begin(capture, &frame);
//     if (!status) status = taa_capture_plane(capture, "color", TAA_RGBA16F, 1920, 1080, pitch,
//                                             TAA_ROWS_TOP_FIRST, mapped); // and motion, depth …
//     if (!status) status = taa_capture_end(capture);
//   }
//   if (status) puts(taa_capture_text(status));
//   taa_capture_close(capture); // NULL is fine
//
// Planes are written as they lie in memory, on little-endian machines. Every file is written beside its place
// and renamed: there are whole files only. Each call blocks for its own writes and for nothing else. Memory
// is taken by open, begin, end and object, never by plane. What TAA Inspector would refuse to open is an
// error here, but for keys and values of `like` and `conventions`, which it names. capture.json is rewritten
// at every end of a frame, about 1 kB for each frame so far (1 MB at frame 1000, beside 50 MB of planes at
// 1080p): when the engine crashes, the frames that were ended are a whole capture. Functions of one capture
// are called by one thread at a time. After an error the capture can still be used: a plane that failed is
// not part of it, nor is a frame whose color failed.
#ifndef TAA_CAPTURE_H
#define TAA_CAPTURE_H

#include <stddef.h>

// clang-format off
// How a pixel lies in memory. D24S8: depth in the lower 24 bits, as in Direct3D and Vulkan; D24S8_GL: in the
// upper, as GL_UNSIGNED_INT_24_8. D32F_S8: 8 bytes, the float first. RGBA8_SRGB: decoded to linear when read.
typedef enum taa_format {
  TAA_R11G11B10F, TAA_RGBA16F, TAA_RGBA32F, TAA_RG16F, TAA_RG32F, TAA_RG16_UNORM, TAA_RGBA8_UNORM,
  TAA_RGBA8_SRGB, TAA_R16F, TAA_R32F, TAA_D32F, TAA_D24S8, TAA_D32F_S8, TAA_R16_UNORM, TAA_R8_UNORM,
  TAA_RG8_UNORM, TAA_R8_UINT, TAA_R16_UINT, TAA_R32_UINT, TAA_D24S8_GL
} taa_format;

typedef enum taa_rows { TAA_ROWS_AS_CONVENTIONS, TAA_ROWS_TOP_FIRST, TAA_ROWS_BOTTOM_FIRST } taa_rows;

// What functions return; taa_capture_text() says it in words.
typedef enum taa_status {
  TAA_OK, TAA_ERROR_ARGUMENT, TAA_ERROR_MEMORY, TAA_ERROR_FOLDER, TAA_ERROR_EXISTS, TAA_ERROR_WRITE,
  TAA_ERROR_ORDER, TAA_ERROR_NUMBER, TAA_ERROR_PLANE, TAA_ERROR_CONVENTION
} taa_status;
// clang-format on

typedef struct taa_capture taa_capture;

// Set all of it to 0 first. Texts are UTF-8 and may be NULL but for `folder`.
typedef struct taa_capture_desc {
  const char* folder;              // made if its parent is there
  int width, height;               // of color: the render size; sides 1 to 16384, 2^26 pixels at most
  int output_width, output_height; // of your own TAA's output; 0: the render size
  const char* like; // whose conventions are yours: taa-inspector, unreal, unity, godot, bevy, three,
                    // babylon, fsr, xess, streamline, metalfx, blender
  const char* const* conventions; // "key=value" where you differ, NULL after the last one
  const char *name, *engine;      // for people
  double frames_per_second;       // 0.001 to 100000; 0: 60
  int replace;                    // 1: a capture that is there already is replaced; 0: TAA_ERROR_EXISTS
} taa_capture_desc;

// Set all of it to 0 first. Matrices: 16 numbers as your conventions say, floats or doubles, whichever is not
// NULL; a view and its projection stand together; previous ones default to those of the frame before.
typedef struct taa_capture_frame {
  int number; // rising, from 0
  double jitter[2];
  const float *view, *projection, *previous_view, *previous_projection;
  const double *view64, *projection64, *previous_view64, *previous_projection64;
  double pre_exposure; // above 0; 0: 1
  int cut;             // 1: history starts here
  int has_seconds; // 1: `seconds` is the frame's time, rising; 0: from frames_per_second; all frames alike
  double seconds;
} taa_capture_frame;

#ifdef __cplusplus
extern "C" {
#endif

// *capture is NULL unless TAA_OK is returned.
int taa_capture_open(taa_capture** capture, const taa_capture_desc* desc);
// Ends the frame before if it was not.
int taa_capture_begin(taa_capture* capture, const taa_capture_frame* frame);
// A plane of the frame that was begun: "color", "motion", "depth", "objectId", "normal", "previousDepth",
// "mask", "overlay", "fog", "output", "reference". Color has the render size, output the output size, no
// other is larger than both; ids are of an integer format. `row_pitch`: bytes from row to row, 0: no gaps.
int taa_capture_plane(taa_capture* capture, const char* name, taa_format format, int width, int height,
                      size_t row_pitch, taa_rows rows, const void* pixels);
// A frame without color is no part of the capture, and an error unless it has no plane at all.
int taa_capture_end(taa_capture* capture);
// The name of an object id, 1 and above, at any time, once for each.
int taa_capture_object(taa_capture* capture, unsigned id, const char* name);
// Ends the frame if it was not, and frees the capture whatever it returns.
int taa_capture_close(taa_capture* capture);
const char* taa_capture_text(int status);

#ifdef __cplusplus
}
#endif

#endif // TAA_CAPTURE_H

#if defined(TAA_CAPTURE_IMPLEMENTATION) && !defined(TAA_CAPTURE_IMPLEMENTED)
#define TAA_CAPTURE_IMPLEMENTED

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef _WIN32
#include <direct.h>
#else
#include <sys/stat.h>
#endif

#define TAA_PLANE_KINDS 11

// A text that grows.
typedef struct taa_buffer {
  char* text;
  size_t length, room;
  int failed; // 0, or why: memory ran out, or a number was not finite
} taa_buffer;

struct taa_capture {
  char* path; // of the folder, with room for the name of a file after it
  size_t folder_length;
  taa_buffer head, objects, frames, frame; // parts of capture.json
  taa_buffer ids;                          // of objects, as they lie in memory
  int width, height, output_width, output_height;
  int last_number, frame_open;
  int has_seconds, frame_has_seconds; // has_seconds: of the frames so far
  double last_seconds, frame_seconds;
  unsigned planes_written; // of the frame, one bit for each kind
};

// clang-format off
static const struct taa_plane_row {
  const char* name;
  int channels; // that it needs; 0: a whole number
} taa_plane_rows[TAA_PLANE_KINDS] = {
    {"color", 3}, {"motion", 2}, {"depth", 1}, {"objectId", 0}, {"normal", 3}, {"previousDepth", 1}, {"mask", 1},
    {"overlay", 4}, {"fog", 3}, {"output", 3}, {"reference", 3}};
enum { TAA_COLOR = 0, TAA_OUTPUT = 9 };
static const struct taa_format_row {
  const char* name;
  unsigned bytes;
  int channels; // 0: a whole number
} taa_format_rows[] = {
    {"R11G11B10F", 4, 3}, {"RGBA16F", 8, 4}, {"RGBA32F", 16, 4}, {"RG16F", 4, 2}, {"RG32F", 8, 2}, {"RG16_UNORM", 4, 2},
    {"RGBA8_UNORM", 4, 4}, {"RGBA8_SRGB", 4, 4}, {"R16F", 2, 1}, {"R32F", 4, 1}, {"D32F", 4, 1}, {"D24S8", 4, 1},
    {"D32F_S8", 8, 1}, {"R16_UNORM", 2, 1}, {"R8_UNORM", 1, 1}, {"RG8_UNORM", 2, 2}, {"R8_UINT", 1, 0}, {"R16_UINT", 2, 0},
    {"R32_UINT", 4, 0}, {"D24S8_GL", 4, 1}};
// clang-format on

static void taa_reserve(taa_buffer* buffer, size_t length) {
  const size_t room = 2 * buffer->room + length + 256;
  char* grown;
  if (buffer->failed || buffer->room - buffer->length >= length) return;
  grown = (char*)realloc(buffer->text, room);
  buffer->failed = grown ? 0 : TAA_ERROR_MEMORY;
  if (!grown) return;
  buffer->text = grown;
  buffer->room = room;
}

static void taa_append(taa_buffer* buffer, const char* text, size_t length) {
  taa_reserve(buffer, length);
  if (buffer->failed) return;
  memcpy(buffer->text + buffer->length, text, length);
  buffer->length += length;
}

static void taa_print(taa_buffer* buffer, const char* text) {
  taa_append(buffer, text, strlen(text));
}

// Some texts, NULL after the last one.
static void taa_print_all(taa_buffer* buffer, const char* text, ...) {
  va_list texts;
  va_start(texts, text);
  for (; text; text = va_arg(texts, const char*)) taa_print(buffer, text);
  va_end(texts);
}

// Bytes of the UTF-8 letter at `at`, 0 where there is none.
static size_t taa_utf8(const unsigned char* at) {
  const size_t length = at[0] < 0x80                    ? 1
                        : at[0] >= 0xc2 && at[0] < 0xe0 ? 2
                        : (at[0] & 0xf0) == 0xe0        ? 3
                        : at[0] >= 0xf0 && at[0] < 0xf5 ? 4
                                                        : 0;
  size_t i;
  for (i = 1; i < length; ++i)
    if ((at[i] & 0xc0) != 0x80) return 0;
  if ((at[0] == 0xe0 && at[1] < 0xa0) || (at[0] == 0xed && at[1] > 0x9f))
    return 0; // too long; half of a pair
  if ((at[0] == 0xf0 && at[1] < 0x90) || (at[0] == 0xf4 && at[1] > 0x8f))
    return 0; // too long; above U+10FFFF
  return length;
}

// As a JSON string; control characters become spaces, bytes that are not UTF-8 question marks. What is longer
// than 4096 bytes ends there.
static void taa_print_string(taa_buffer* buffer, const char* text, size_t length) {
  const unsigned char* at = (const unsigned char*)text;
  const unsigned char* end = at + (length < 4096 ? length : 4096);
  taa_print(buffer, "\"");
  while (at < end) {
    const size_t letter = taa_utf8(at);
    const int is_control = *at < 0x20 || *at == 0x7f || (letter == 2 && *at == 0xc2 && at[1] < 0xa0);
    if (at + letter > end) break;
    if (*at == '"' || *at == '\\') taa_print(buffer, "\\");
    if (letter > 0 && !is_control)
      taa_append(buffer, (const char*)at, letter);
    else
      taa_print(buffer, letter ? " " : "?");
    at += letter ? letter : 1;
  }
  taa_print(buffer, "\"");
}

// In JSON's spelling whatever setlocale() was told: the locale's decimal point, of one byte or several, is
// all that is no digit, sign or exponent. Looks at letters, not isfinite(): -ffast-math takes that away.
static void taa_print_number(taa_buffer* buffer, double number, int digits, double limit) {
  char printed[64];
  const char* from = printed;
  snprintf(printed, sizeof(printed), "%.*g", digits, number);
  if (strpbrk(printed, "nN") || number > limit || number < -limit) { // nan, inf
    if (!buffer->failed) buffer->failed = TAA_ERROR_NUMBER;
    return;
  }
  while (*from) {
    const size_t plain = strspn(from, "0123456789+-e");
    taa_append(buffer, from, plain);
    from += plain;
    if (*from) taa_print(buffer, ".");
    from += strcspn(from, "0123456789+-e");
  }
}

static void taa_print_matrix(taa_buffer* buffer, const char* key, const float* floats,
                             const double* doubles) {
  int i;
  if (!floats && !doubles) return;
  taa_print_all(buffer, ", \"", key, "\": [", (char*)NULL);
  for (i = 0; i < 16; ++i) {
    if (i > 0) taa_print(buffer, ", ");
    taa_print_number(buffer, doubles ? doubles[i] : (double)floats[i], doubles ? 17 : 9, 1e30);
  }
  taa_print(buffer, "]");
}

static void taa_print_field(taa_buffer* buffer, const char* key, const char* text) {
  if (!text) return;
  taa_print_all(buffer, ",\n \"", key, "\": ", (char*)NULL);
  taa_print_string(buffer, text, strlen(text));
}

static void taa_print_size(taa_buffer* buffer, const char* key, int width, int height) {
  char size[64];
  snprintf(size, sizeof(size), ": [%d, %d]", width, height);
  taa_print_all(buffer, key, size, (char*)NULL);
}

// true, false and numbers as JSON has them, all else as a string.
static void taa_print_value(taa_buffer* buffer, const char* value) {
  const char* digits = value + (*value == '-');
  const size_t whole = strspn(digits, "0123456789");
  const char* rest = digits + whole;
  int is_number = whole > 0 && (whole == 1 || *digits != '0');
  if (*rest == '.') {
    is_number = is_number && rest[1] >= '0' && rest[1] <= '9';
    rest += 1 + strspn(rest + 1, "0123456789");
  }
  if (*rest == 'e' || *rest == 'E') {
    rest += 1 + (rest[1] == '-' || rest[1] == '+');
    is_number = is_number && *rest >= '0' && *rest <= '9';
    rest += strspn(rest, "0123456789");
  }
  if ((is_number && *rest == 0) || strcmp(value, "true") == 0 || strcmp(value, "false") == 0)
    taa_print(buffer, value);
  else if (strcmp(value, "on") == 0 || strcmp(value, "off") == 0)
    taa_print(buffer, value[1] == 'n' ? "true" : "false");
  else
    taa_print_string(buffer, value, strlen(value));
}

// "motion.unit=uv" and its like, those of a group together: {"motion": {"unit": "uv"}, "rows": "topFirst"}.
static int taa_print_conventions(taa_buffer* buffer, const char* const* given) {
  size_t i, k, groups = 0;
  taa_print(buffer, ",\n \"conventions\": {");
  for (i = 0; given[i]; ++i) {
    const char* equals = strchr(given[i], '=');
    const char* dot = strchr(given[i], '.');
    size_t group, entries = 0;
    int is_known = 0;
    if (!equals || equals == given[i] || equals[1] == 0) return TAA_ERROR_CONVENTION;
    if (dot && dot > equals) dot = NULL;
    group = (size_t)((dot ? dot + 1 : equals) - given[i]); // with its dot
    for (k = 0; k < i; ++k) {
      if (strncmp(given[k], given[i], (size_t)(equals - given[i]) + 1) == 0) return TAA_ERROR_CONVENTION;
      is_known = is_known || (dot && strncmp(given[k], given[i], group) == 0);
    }
    if (is_known) continue;
    if (groups++ > 0) taa_print(buffer, ", ");
    if (!dot) {
      taa_print_string(buffer, given[i], group);
      taa_print(buffer, ": ");
      taa_print_value(buffer, equals + 1);
      continue;
    }
    taa_print_string(buffer, given[i], group - 1);
    taa_print(buffer, ": {");
    for (k = i; given[k]; ++k) {
      if (strncmp(given[k], given[i], group) != 0) continue;
      equals = strchr(given[k], '=');
      if (!equals || equals < given[k] + group) return TAA_ERROR_CONVENTION;
      if (entries++ > 0) taa_print(buffer, ", ");
      taa_print_string(buffer, given[k] + group, (size_t)(equals - given[k]) - group);
      taa_print(buffer, ": ");
      taa_print_value(buffer, equals + 1);
    }
    taa_print(buffer, "}");
  }
  taa_print(buffer, "}");
  return TAA_OK;
}

static FILE* taa_start(taa_capture* capture) {
  strcpy(capture->path + capture->folder_length, "/.taa_capture.part");
  return fopen(capture->path, "wb");
}

// What was started becomes FOLDER/name, unless that failed.
static int taa_finish(taa_capture* capture, FILE* file, int written, const char* name) {
  const size_t part_length = strlen(capture->path);
  char* target = capture->path + part_length + 1;
  if (!file) return TAA_ERROR_FOLDER;
  written = fclose(file) == 0 && written;
  memcpy(target, capture->path, capture->folder_length);
  target[capture->folder_length] = '/';
  strcpy(target + capture->folder_length + 1, name);
  if (written && rename(capture->path, target) == 0) return TAA_OK;
#ifdef _WIN32
  if (written && remove(target) == 0 && rename(capture->path, target) == 0)
    return TAA_OK; // replaces nothing there
#endif
  remove(capture->path);
  return TAA_ERROR_WRITE;
}

static int taa_put(FILE* file, const taa_buffer* buffer) {
  return buffer->length == 0 || fwrite(buffer->text, 1, buffer->length, file) == buffer->length;
}

static int taa_write_manifest(taa_capture* capture) {
  FILE* file = taa_start(capture);
  const int written = file && taa_put(file, &capture->head) && fputs(",\n \"objects\": {", file) >= 0 &&
                      taa_put(file, &capture->objects) && fputs("},\n \"frames\": [", file) >= 0 &&
                      taa_put(file, &capture->frames) && fputs("\n ]\n}\n", file) >= 0;
  return taa_finish(capture, file, written, "capture.json");
}

static void taa_free(taa_capture* capture) {
  free(capture->path);
  free(capture->head.text);
  free(capture->objects.text);
  free(capture->ids.text);
  free(capture->frames.text);
  free(capture->frame.text);
  free(capture);
}

static int taa_is_size(int width, int height) {
  return width >= 1 && width <= 16384 && height >= 1 && height <= 16384 &&
         (size_t)width * (size_t)height <= (size_t)1 << 26;
}

// Whether a frame can be: both or none of a view and its projection, previous ones beside those of now.
static int taa_has_pairs(const taa_capture_frame* frame) {
  const int view = frame->view || frame->view64, projection = frame->projection || frame->projection64;
  const int before = frame->previous_view || frame->previous_view64;
  const int previous_projection = frame->previous_projection || frame->previous_projection64;
  return view == projection && before == previous_projection && (view || !before);
}

static int taa_print_head(taa_buffer* head, const taa_capture_desc* desc) {
  static const char* const none[] = {NULL};
  int status;
  taa_print(head, "{\n \"format\": 1");
  taa_print_field(head, "name", desc->name);
  taa_print_field(head, "engine", desc->engine);
  taa_print_field(head, "like", desc->like);
  status = taa_print_conventions(head, desc->conventions ? desc->conventions : none);
  taa_print_size(head, ",\n \"size\"", desc->width, desc->height);
  if (desc->output_width > 0)
    taa_print_size(head, ",\n \"outputSize\"", desc->output_width, desc->output_height);
  taa_print(head, ",\n \"framesPerSecond\": ");
  taa_print_number(head, desc->frames_per_second != 0 ? desc->frames_per_second : 60.0, 17, 1e5);
  return status ? status : head->failed;
}

// Makes the folder; a capture that is there ends here, so that it never names the new one's planes.
static int taa_prepare_folder(taa_capture* capture, int replace) {
  FILE* file;
#ifdef _WIN32
  _mkdir(capture->path);
#else
  mkdir(capture->path, 0777);
#endif
  strcpy(capture->path + capture->folder_length, "/capture.json");
  file = fopen(capture->path, "rb");
  if (!file) return TAA_OK; // a folder that cannot be written is met by the first file
  fclose(file);
  if (!replace) return TAA_ERROR_EXISTS;
  return remove(capture->path) == 0 ? TAA_OK : TAA_ERROR_FOLDER;
}

int taa_capture_open(taa_capture** capture, const taa_capture_desc* desc) {
  taa_capture* opened;
  int status;
  if (!capture) return TAA_ERROR_ARGUMENT;
  *capture = NULL;
  if (!desc || !desc->folder || !*desc->folder || !taa_is_size(desc->width, desc->height) ||
      ((desc->output_width != 0 || desc->output_height != 0) &&
       !taa_is_size(desc->output_width, desc->output_height)) ||
      (desc->frames_per_second != 0 && desc->frames_per_second < 1e-3))
    return TAA_ERROR_ARGUMENT;
  opened = (taa_capture*)calloc(1, sizeof(taa_capture));
  if (!opened) return TAA_ERROR_MEMORY;
  opened->folder_length = strlen(desc->folder);
  opened->last_number = -1;
  opened->width = desc->width;
  opened->height = desc->height;
  opened->output_width = desc->output_width ? desc->output_width : desc->width;
  opened->output_height = desc->output_height ? desc->output_height : desc->height;
  opened->path = (char*)malloc(2 * opened->folder_length + 128); // "FOLDER/.taa_capture.part" "FOLDER/name"
  status = opened->path ? taa_print_head(&opened->head, desc) : TAA_ERROR_MEMORY;
  if (!status) {
    strcpy(opened->path, desc->folder);
    status = taa_prepare_folder(opened, desc->replace);
  }
  if (!status) { // tries the folder: better now than after the first frame
    FILE* file = taa_start(opened);
    if (!file || fclose(file) != 0 || remove(opened->path) != 0) status = TAA_ERROR_FOLDER;
  }
  if (status)
    taa_free(opened);
  else
    *capture = opened;
  return status;
}

int taa_capture_begin(taa_capture* capture, const taa_capture_frame* frame) {
  taa_buffer* text;
  char number[32];
  int status;
  if (!capture || !frame || frame->number < 0 || !taa_has_pairs(frame)) return TAA_ERROR_ARGUMENT;
  status = taa_capture_end(capture);
  if (status && status != TAA_ERROR_ORDER) return status;
  if (frame->number <= capture->last_number) return TAA_ERROR_ORDER;
  if (capture->frames.length > 0 && (!frame->has_seconds != !capture->has_seconds ||
                                     (frame->has_seconds && !(frame->seconds > capture->last_seconds))))
    return TAA_ERROR_ORDER;
  text = &capture->frame;
  text->length = 0;
  text->failed = 0;
  snprintf(number, sizeof(number), "%d", frame->number);
  taa_print_all(text, "\n  {\"number\": ", number, ", \"jitter\": [", (char*)NULL);
  taa_print_number(text, frame->jitter[0], 17, 1e6);
  taa_print(text, ", ");
  taa_print_number(text, frame->jitter[1], 17, 1e6);
  taa_print(text, "]");
  taa_print_matrix(text, "view", frame->view, frame->view64);
  taa_print_matrix(text, "projection", frame->projection, frame->projection64);
  taa_print_matrix(text, "previousView", frame->previous_view, frame->previous_view64);
  taa_print_matrix(text, "previousProjection", frame->previous_projection, frame->previous_projection64);
  if (frame->pre_exposure != 0) {
    taa_print(text, ", \"preExposure\": ");
    taa_print_number(text, frame->pre_exposure, 17, 1e12);
    if (frame->pre_exposure < 1e-12 && !text->failed) text->failed = TAA_ERROR_NUMBER;
  }
  if (frame->cut) taa_print(text, ", \"cut\": true");
  if (frame->has_seconds) {
    taa_print(text, ", \"seconds\": ");
    taa_print_number(text, frame->seconds, 17, 1e9);
  }
  taa_print(text, ", \"planes\": {");
  taa_reserve(text, TAA_PLANE_KINDS * 256); // for all planes, so that none has to be made later
  if (text->failed) return text->failed;
  capture->last_number = frame->number;
  capture->frame_open = 1;
  capture->frame_has_seconds = frame->has_seconds;
  capture->frame_seconds = frame->seconds;
  capture->planes_written = 0;
  return TAA_OK;
}

// Whether TAA Inspector takes a plane of this format and size for one of the kind.
static int taa_can_be(const taa_capture* capture, int kind, taa_format format, int width, int height) {
  const int is_color = kind == TAA_COLOR, needed = taa_plane_rows[kind].channels;
  const int has = taa_format_rows[format].channels;
  if ((needed == 0) != (has == 0) || has < needed) return 0;
  if (is_color || kind == TAA_OUTPUT)
    return width == (is_color ? capture->width : capture->output_width) &&
           height == (is_color ? capture->height : capture->output_height);
  return (width <= capture->width || width <= capture->output_width) &&
         (height <= capture->height || height <= capture->output_height);
}

int taa_capture_plane(taa_capture* capture, const char* name, taa_format format, int width, int height,
                      size_t row_pitch, taa_rows rows, const void* pixels) {
  char file_name[64];
  size_t row_bytes, pitch, bytes;
  FILE* file;
  taa_buffer* text;
  int kind = 0, status;
  if (!capture || !name || !pixels || !taa_is_size(width, height) || (int)format < 0 ||
      (size_t)format >= sizeof(taa_format_rows) / sizeof(taa_format_rows[0]) || (int)rows < 0 ||
      (int)rows > 2)
    return TAA_ERROR_ARGUMENT;
  while (kind < TAA_PLANE_KINDS && strcmp(taa_plane_rows[kind].name, name) != 0) ++kind;
  if (kind == TAA_PLANE_KINDS || !taa_can_be(capture, kind, format, width, height)) return TAA_ERROR_PLANE;
  if (!capture->frame_open || (capture->planes_written >> kind & 1u) != 0) return TAA_ERROR_ORDER;
  row_bytes = (size_t)width * taa_format_rows[format].bytes;
  pitch = row_pitch ? row_pitch : row_bytes;
  if (pitch < row_bytes || pitch > (size_t)1 << 30 || pitch > ((size_t)-1 - row_bytes) / (size_t)height)
    return TAA_ERROR_ARGUMENT;
  bytes = pitch * (size_t)(height - 1) + row_bytes; // nothing behind the last pixel is read
  snprintf(file_name, sizeof(file_name), "%s.%04d.raw", name, capture->last_number);
  file = taa_start(capture);
  status = taa_finish(capture, file, file && fwrite(pixels, 1, bytes, file) == bytes, file_name);
  if (status) return status;
  text = &capture->frame;
  taa_print_all(text, capture->planes_written ? ",\n   \"" : "\n   \"", name, "\": {\"file\": \"", file_name,
                "\", \"raw\": \"", taa_format_rows[format].name, (char*)NULL);
  taa_print_size(text, "\", \"size\"", width, height);
  taa_print(text, ", \"rowPitch\": ");
  taa_print_number(text, (double)pitch, 17, 1e10);
  if (rows)
    taa_print(text, rows == TAA_ROWS_TOP_FIRST ? ", \"rows\": \"topFirst\"" : ", \"rows\": \"bottomFirst\"");
  taa_print(text, "}");
  capture->planes_written |= 1u << kind;
  return TAA_OK;
}

int taa_capture_end(taa_capture* capture) {
  const size_t length = capture ? capture->frames.length : 0;
  if (!capture) return TAA_ERROR_ARGUMENT;
  if (!capture->frame_open) return TAA_ERROR_ORDER;
  capture->frame_open = 0;
  if (!capture->planes_written) return TAA_OK; // a frame of nothing is none
  if (!(capture->planes_written >> TAA_COLOR & 1u)) return TAA_ERROR_PLANE;
  if (length > 0) taa_print(&capture->frames, ",");
  taa_append(&capture->frames, capture->frame.text, capture->frame.length);
  taa_print(&capture->frames, "}}");
  if (capture->frames.failed) { // as it was before
    capture->frames.length = length;
    capture->frames.failed = 0;
    return TAA_ERROR_MEMORY;
  }
  capture->has_seconds = capture->frame_has_seconds;
  capture->last_seconds = capture->frame_seconds;
  return taa_write_manifest(capture);
}

int taa_capture_object(taa_capture* capture, unsigned id, const char* name) {
  const size_t length = capture ? capture->objects.length : 0;
  char key[32];
  size_t at;
  if (!capture || !name || id == 0) return TAA_ERROR_ARGUMENT;
  for (at = 0; at < capture->ids.length; at += sizeof(id))
    if (memcmp(capture->ids.text + at, &id, sizeof(id)) == 0) return TAA_ERROR_ORDER;
  taa_reserve(&capture->ids, sizeof(id));
  snprintf(key, sizeof(key), "%s\"%u\": ", length ? ", " : "", id);
  taa_print(&capture->objects, key);
  taa_print_string(&capture->objects, name, strlen(name));
  if (!capture->objects.failed && !capture->ids.failed) {
    taa_append(&capture->ids, (const char*)&id, sizeof(id));
    return TAA_OK;
  }
  capture->objects.length = length;
  capture->objects.failed = capture->ids.failed = 0;
  return TAA_ERROR_MEMORY;
}

int taa_capture_close(taa_capture* capture) {
  int status, written;
  if (!capture) return TAA_OK;
  status = taa_capture_end(capture);
  // Objects may have been named since the last frame ended.
  written = capture->frames.length > 0 ? taa_write_manifest(capture) : TAA_OK;
  taa_free(capture);
  return status == TAA_OK || status == TAA_ERROR_ORDER ? written : status;
}

const char* taa_capture_text(int status) {
  switch (status) {
  case TAA_OK:
    return "done";
  case TAA_ERROR_ARGUMENT:
    return "an argument is NULL or out of its range";
  case TAA_ERROR_MEMORY:
    return "there is not enough memory";
  case TAA_ERROR_FOLDER:
    return "the folder cannot be made or written to";
  case TAA_ERROR_EXISTS:
    return "there is a capture in the folder already; set replace, or choose another one";
  case TAA_ERROR_WRITE:
    return "a file could not be written; the disk may be full";
  case TAA_ERROR_ORDER:
    return "no frame was begun, its number or time does not rise, or the plane or object was stated before";
  case TAA_ERROR_NUMBER:
    return "a jitter, matrix, exposure or time is not a finite number within its range";
  case TAA_ERROR_PLANE:
    return "there is no plane of this name, it has another format or size, or the frame has no color";
  case TAA_ERROR_CONVENTION:
    return "a convention is not of the form key=value, or is stated twice";
  default:
    return "unknown status";
  }
}

#endif // TAA_CAPTURE_IMPLEMENTATION
