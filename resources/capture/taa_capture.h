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
// Planes are written as they lie in memory, on little-endian machines; there are whole files only. A call
// blocks for its own writes and for nothing else; plane takes no memory. Functions of one capture are called
// by one thread at a time. What TAA Inspector would refuse to open is an error here, but for keys and values
// of `like` and `conventions`, which it names. After an error the capture can still be used: a plane that
// failed is not part of it, nor is a frame whose color failed. After a crash it has the frames that were
// ended. The manual has more about it (engines).
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
#define taa_make_folder(path) _mkdir(path)
#else
#include <sys/stat.h>
#define taa_make_folder(path) mkdir(path, 0777)
#endif

#define TAA_MOST_BYTES 4096 // of a text in capture.json

// A text that grows; what cannot be added to it leaves why in `failed`.
typedef struct taa_text {
  char* at;
  size_t length, room;
  int failed;
} taa_text;

struct taa_capture {
  taa_capture_desc desc;       // its numbers: the texts are the caller's
  char *part, *file, *name;    // FOLDER/.taa_capture.part, FOLDER/name; the name in that
  taa_text head, frames;       // of capture.json: up to its objects; its frames
  size_t ended;                // bytes of `frames` that are of frames that were ended
  taa_capture_frame now, last; // their numbers and times: begun last, ended last
  int is_open;
  unsigned planes, largest_id; // planes: of the frame, one bit for each kind
};

// clang-format off
// Channels that a plane needs and a format has; 0: a whole number.
static const struct { const char* name; int channels; } taa_planes[] = {
  {"color", 3}, {"motion", 2}, {"depth", 1}, {"objectId", 0}, {"normal", 3}, {"previousDepth", 1}, {"mask", 1},
  {"overlay", 4}, {"fog", 3}, {"output", 3}, {"reference", 3}};
static const struct { const char* name; unsigned bytes; int channels; } taa_formats[] = {
  {"R11G11B10F", 4, 3}, {"RGBA16F", 8, 4}, {"RGBA32F", 16, 4}, {"RG16F", 4, 2}, {"RG32F", 8, 2}, {"RG16_UNORM", 4, 2},
  {"RGBA8_UNORM", 4, 4}, {"RGBA8_SRGB", 4, 4}, {"R16F", 2, 1}, {"R32F", 4, 1}, {"D32F", 4, 1}, {"D24S8", 4, 1},
  {"D32F_S8", 8, 1}, {"R16_UNORM", 2, 1}, {"R8_UNORM", 1, 1}, {"RG8_UNORM", 2, 2}, {"R8_UINT", 1, 0}, {"R16_UINT", 2, 0},
  {"R32_UINT", 4, 0}, {"D24S8_GL", 4, 1}};
enum {
  TAA_COLOR = 0, TAA_OUTPUT = 9,
  TAA_PLANES = sizeof(taa_planes) / sizeof(taa_planes[0]), TAA_FORMATS = sizeof(taa_formats) / sizeof(taa_formats[0])
};
// clang-format on

static void taa_reserve(taa_text* text, size_t length) {
  const size_t room = 2 * text->room + length + 256;
  char* grown;
  if (text->failed || text->room - text->length > length) return; // with the 0 at its end
  grown = (char*)realloc(text->at, room);
  text->failed = grown ? TAA_OK : TAA_ERROR_MEMORY;
  if (!grown) return;
  text->at = grown;
  text->room = room;
}

// As printf; no number but whole ones, as locales have points of their own.
static void taa_print(taa_text* text, const char* format, ...) {
  va_list values;
  int length;
  va_start(values, format);
  length = vsnprintf(NULL, 0, format, values);
  va_end(values);
  taa_reserve(text, (size_t)length);
  if (text->failed) return;
  va_start(values, format);
  vsnprintf(text->at + text->length, (size_t)length + 1, format, values);
  va_end(values);
  text->length += (size_t)length;
}

// What went wrong with the text since it had `length`, which it then has again.
static int taa_settle(taa_text* text, size_t length) {
  const int failed = text->failed;
  text->failed = TAA_OK;
  if (failed) text->length = length;
  if (failed && text->at) text->at[length] = 0;
  return failed;
}

// Bytes of the UTF-8 letter at `at`, 0 where there is none.
static size_t taa_utf8(const unsigned char* at) {
  static const unsigned char lengths[] = {1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 2, 2, 3, 4}; // by the high bits
  static const unsigned least[] = {0, 0, 0x80, 0x800, 0x10000}; // letters of so many bytes
  const size_t length = lengths[*at >> 4];
  unsigned letter = length > 1 ? *at & (0xffu >> length) : *at;
  for (size_t i = 1; i < length; ++i) {
    if ((at[i] & 0xc0) != 0x80) return 0;
    letter = letter << 6 | (at[i] & 0x3fu);
  }
  return letter < least[length] || letter > 0x10ffff || letter >> 11 == 0xd800 >> 11 ? 0 : length;
}

// `before`, then `text` as a JSON string: control characters become spaces, bytes that are not UTF-8 question
// marks, and it ends where it is too long.
static void taa_print_string(taa_text* to, const char* before, const char* text) {
  char escaped[2 * TAA_MOST_BYTES + 1];
  size_t read = 0, length = 0;
  while (text[read] && read < TAA_MOST_BYTES) {
    const unsigned char* at = (const unsigned char*)text + read;
    const size_t letter = taa_utf8(at);
    const int is_control = *at < 0x20 || *at == 0x7f || (*at == 0xc2 && letter == 2 && at[1] < 0xa0);
    if (read + letter > TAA_MOST_BYTES) break;
    if (*at == '"' || *at == '\\') escaped[length++] = '\\';
    if (is_control || !letter) escaped[length++] = letter ? ' ' : '?';
    for (size_t i = 0; i < letter && !is_control; ++i) escaped[length++] = (char)at[i];
    read += letter ? letter : 1;
  }
  escaped[length] = 0;
  taa_print(to, "%s\"%s\"", before, escaped);
}

// In JSON's spelling whatever setlocale() was told: the locale's decimal point, of one byte or several, is
// all that is no digit, sign or exponent. Looks at letters, not isfinite(): -ffast-math takes that away.
static void taa_print_number(taa_text* to, const char* before, double number, int digits, double limit) {
  char text[64];
  size_t whole, point;
  snprintf(text, sizeof(text), "%.*g", digits, number);
  if ((strpbrk(text, "nN") || number > limit || number < -limit) && !to->failed) // nan, inf
    to->failed = TAA_ERROR_NUMBER;
  whole = strspn(text, "0123456789+-e");
  point = strcspn(text + whole, "0123456789+-e");
  taa_print(to, "%s%.*s%s%s", before, (int)whole, text, point ? "." : "", text + whole + point);
}

static void taa_print_matrix(taa_text* to, const char* name, const float* floats, const double* doubles) {
  if (!floats && !doubles) return;
  taa_print(to, ", \"%s\": [", name);
  for (int i = 0; i < 16; ++i)
    taa_print_number(to, i ? ", " : "", doubles ? doubles[i] : (double)floats[i], doubles ? 17 : 9, 1e30);
  taa_print(to, "]");
}

// FOLDER/name, whole or as it was before.
static int taa_write(taa_capture* capture, const char* name, const void* const* pieces,
                     const size_t* lengths) {
  FILE* file = fopen(capture->part, "wb");
  int written = 1;
  if (!file) return TAA_ERROR_FOLDER;
  for (; *lengths && written; ++pieces, ++lengths) written = fwrite(*pieces, 1, *lengths, file) == *lengths;
  written = fclose(file) == 0 && written;
  strcpy(capture->name, name);
  if (written && rename(capture->part, capture->file) == 0) return TAA_OK;
#ifdef _WIN32
  if (written && remove(capture->file) == 0 && rename(capture->part, capture->file) == 0)
    return TAA_OK; // replaces nothing there
#endif
  remove(capture->part);
  return TAA_ERROR_WRITE;
}

static int taa_write_manifest(taa_capture* capture) {
  static const char end[] = "\n ]\n}\n";
  const void* const pieces[] = {capture->head.at, capture->frames.at, end};
  const size_t lengths[] = {capture->head.length, capture->ended, sizeof(end) - 1, 0};
  return taa_write(capture, "capture.json", pieces, lengths);
}

static int taa_is_size(int width, int height) {
  return width >= 1 && width <= 16384 && height >= 1 && height <= 16384 &&
         (size_t)width * (size_t)height <= (size_t)1 << 26;
}

static int taa_print_head(taa_text* head, const taa_capture_desc* desc) {
  const char* const* given = desc->conventions;
  taa_print(head, "{\n \"format\": 1");
  if (desc->name) taa_print_string(head, ",\n \"name\": ", desc->name);
  if (desc->engine) taa_print_string(head, ",\n \"engine\": ", desc->engine);
  if (desc->like) taa_print_string(head, ",\n \"like\": ", desc->like);
  for (int i = 0; given && given[i]; ++i) {
    const size_t key = strcspn(given[i], "=");
    if (key == 0 || !given[i][key] || !given[i][key + 1]) return TAA_ERROR_CONVENTION;
    for (int k = 0; k < i; ++k)
      if (strncmp(given[k], given[i], key + 1) == 0) return TAA_ERROR_CONVENTION;
    taa_print_string(head, i ? ", " : ",\n \"conventions\": [", given[i]);
  }
  taa_print(head, "%s,\n \"size\": [%d, %d]", given && *given ? "]" : "", desc->width, desc->height);
  if (desc->output_width)
    taa_print(head, ",\n \"outputSize\": [%d, %d]", desc->output_width, desc->output_height);
  taa_print_number(head,
                   ",\n \"framesPerSecond\": ", desc->frames_per_second != 0 ? desc->frames_per_second : 60.0,
                   17, 1e5);
  taa_print(head, ",\n \"objects\": {");
  return head->failed;
}

// Makes the folder; a capture that is there ends here, so that it never names the new one's planes.
static int taa_prepare_folder(taa_capture* capture, const char* folder, int replace) {
  const size_t length = strlen(folder), room = length + 64;
  FILE* file;
  capture->part = (char*)malloc(2 * room);
  if (!capture->part) return TAA_ERROR_MEMORY;
  capture->file = capture->part + room;
  capture->name = capture->file + length + 1;
  snprintf(capture->part, room, "%s/.taa_capture.part", folder);
  snprintf(capture->file, room, "%s/capture.json", folder);
  taa_make_folder(folder);
  file = fopen(capture->file, "rb");
  if (file) fclose(file);
  if (file && !replace) return TAA_ERROR_EXISTS;
  if (file && remove(capture->file) != 0) return TAA_ERROR_FOLDER;
  file = fopen(capture->part, "wb"); // tries the folder: better now than after the first frame
  return file && fclose(file) == 0 && remove(capture->part) == 0 ? TAA_OK : TAA_ERROR_FOLDER;
}

static int taa_free(taa_capture* capture, int status) {
  free(capture->part);
  free(capture->head.at);
  free(capture->frames.at);
  free(capture);
  return status;
}

int taa_capture_open(taa_capture** capture, const taa_capture_desc* desc) {
  taa_capture* opened;
  int status;
  if (!capture) return TAA_ERROR_ARGUMENT;
  *capture = NULL;
  if (!desc || !desc->folder || !*desc->folder || !taa_is_size(desc->width, desc->height) ||
      ((desc->output_width || desc->output_height) &&
       !taa_is_size(desc->output_width, desc->output_height)) ||
      (desc->frames_per_second != 0 && desc->frames_per_second < 1e-3))
    return TAA_ERROR_ARGUMENT;
  opened = (taa_capture*)calloc(1, sizeof(taa_capture));
  if (!opened) return TAA_ERROR_MEMORY;
  opened->desc = *desc;
  if (!desc->output_width) opened->desc.output_width = desc->width, opened->desc.output_height = desc->height;
  opened->now.number = -1;
  status = taa_print_head(&opened->head, desc);
  if (!status) status = taa_prepare_folder(opened, desc->folder, desc->replace);
  if (status) return taa_free(opened, status);
  *capture = opened;
  return TAA_OK;
}

int taa_capture_begin(taa_capture* capture, const taa_capture_frame* frame) {
#define TAA_HAS(matrix) (frame->matrix || frame->matrix##64)
  taa_text* text;
  int status;
  if (!capture || !frame || frame->number < 0 || TAA_HAS(view) != TAA_HAS(projection) ||
      TAA_HAS(previous_view) != TAA_HAS(previous_projection) || (TAA_HAS(previous_view) && !TAA_HAS(view)))
    return TAA_ERROR_ARGUMENT;
#undef TAA_HAS
  status = taa_capture_end(capture);
  if (status && status != TAA_ERROR_ORDER) return status;
  if (frame->number <= capture->now.number ||
      (capture->ended && (!frame->has_seconds != !capture->last.has_seconds ||
                          (frame->has_seconds && !(frame->seconds > capture->last.seconds)))))
    return TAA_ERROR_ORDER;
  text = &capture->frames;
  text->length = capture->ended; // a frame that is none is forgotten
  taa_print(text, "%s\n  {\"number\": %d", capture->ended ? "," : "},\n \"frames\": [", frame->number);
  taa_print_number(text, ", \"jitter\": [", frame->jitter[0], 17, 1e6);
  taa_print_number(text, ", ", frame->jitter[1], 17, 1e6);
  taa_print(text, "]");
  taa_print_matrix(text, "view", frame->view, frame->view64);
  taa_print_matrix(text, "projection", frame->projection, frame->projection64);
  taa_print_matrix(text, "previousView", frame->previous_view, frame->previous_view64);
  taa_print_matrix(text, "previousProjection", frame->previous_projection, frame->previous_projection64);
  if (frame->pre_exposure != 0) taa_print_number(text, ", \"preExposure\": ", frame->pre_exposure, 17, 1e12);
  if (frame->pre_exposure != 0 && frame->pre_exposure < 1e-12) text->failed = TAA_ERROR_NUMBER;
  if (frame->has_seconds) taa_print_number(text, ", \"seconds\": ", frame->seconds, 17, 1e9);
  taa_print(text, "%s, \"planes\": {", frame->cut ? ", \"cut\": true" : "");
  taa_reserve(text, TAA_PLANES * 256); // for all planes, so that none has to be made later
  status = taa_settle(text, capture->ended);
  if (status) return status;
  capture->now = *frame;
  capture->is_open = 1;
  capture->planes = 0;
  return TAA_OK;
}

// Whether TAA Inspector takes a plane of this format and size for one of the kind.
static int taa_can_be(const taa_capture_desc* desc, int kind, int format, int width, int height) {
  const int needed = taa_planes[kind].channels, has = taa_formats[format].channels;
  if ((needed == 0) != (has == 0) || has < needed) return 0;
  if (kind == TAA_COLOR) return width == desc->width && height == desc->height;
  if (kind == TAA_OUTPUT) return width == desc->output_width && height == desc->output_height;
  return (width <= desc->width || width <= desc->output_width) &&
         (height <= desc->height || height <= desc->output_height);
}

int taa_capture_plane(taa_capture* capture, const char* name, taa_format format, int width, int height,
                      size_t row_pitch, taa_rows rows, const void* pixels) {
  static const char* const orders[] = {"", ", \"rows\": \"topFirst\"", ", \"rows\": \"bottomFirst\""};
  char file[64];
  size_t row, pitch, bytes[2] = {0, 0};
  int kind = 0, status;
  if (!capture || !name || !pixels || !taa_is_size(width, height) || (int)format < 0 ||
      (int)format >= TAA_FORMATS || (int)rows < 0 || (int)rows > 2)
    return TAA_ERROR_ARGUMENT;
  while (kind < TAA_PLANES && strcmp(taa_planes[kind].name, name) != 0) ++kind;
  if (kind == TAA_PLANES || !taa_can_be(&capture->desc, kind, (int)format, width, height))
    return TAA_ERROR_PLANE;
  if (!capture->is_open || (capture->planes >> kind & 1u)) return TAA_ERROR_ORDER;
  row = (size_t)width * taa_formats[format].bytes;
  pitch = row_pitch ? row_pitch : row;
  if (pitch < row || pitch > (size_t)1 << 30 || pitch > ((size_t)-1 - row) / (size_t)height)
    return TAA_ERROR_ARGUMENT;
  bytes[0] = pitch * (size_t)(height - 1) + row; // nothing behind the last pixel is read
  snprintf(file, sizeof(file), "%s.%04d.raw", name, capture->now.number);
  status = taa_write(capture, file, &pixels, bytes);
  if (status) return status;
  taa_print(&capture->frames,
            "%s\n   \"%s\": {\"file\": \"%s\", \"raw\": \"%s\", \"size\": [%d, %d], \"rowPitch\": %lu%s}",
            capture->planes ? "," : "", name, file, taa_formats[format].name, width, height,
            (unsigned long)pitch, orders[rows]);
  capture->planes |= 1u << kind;
  return TAA_OK;
}

int taa_capture_end(taa_capture* capture) {
  if (!capture) return TAA_ERROR_ARGUMENT;
  if (!capture->is_open) return TAA_ERROR_ORDER;
  capture->is_open = 0;
  if (!capture->planes) return TAA_OK; // a frame of nothing is none
  if (!(capture->planes >> TAA_COLOR & 1u)) return TAA_ERROR_PLANE;
  taa_print(&capture->frames, "}}");
  capture->ended = capture->frames.length;
  capture->last = capture->now;
  return taa_write_manifest(capture);
}

int taa_capture_object(taa_capture* capture, unsigned id, const char* name) {
  char key[32];
  size_t length;
  int status;
  if (!capture || !name || id == 0) return TAA_ERROR_ARGUMENT;
  snprintf(key, sizeof(key), "\"%u\": ", id); // nowhere within a name, whose quotes are escaped
  if (id <= capture->largest_id && strstr(capture->head.at, key)) return TAA_ERROR_ORDER;
  length = capture->head.length;
  if (capture->largest_id) taa_print(&capture->head, ", ");
  taa_print_string(&capture->head, key, name);
  status = taa_settle(&capture->head, length);
  if (!status && id > capture->largest_id) capture->largest_id = id;
  return status;
}

int taa_capture_close(taa_capture* capture) {
  int status, written;
  if (!capture) return TAA_OK;
  status = taa_capture_end(capture);
  // Objects may have been named since the last frame ended.
  written = capture->ended ? taa_write_manifest(capture) : TAA_OK;
  return taa_free(capture, status && status != TAA_ERROR_ORDER ? status : written);
}

const char* taa_capture_text(int status) {
  static const char* const texts[] = {
      "done",
      "an argument is NULL or out of its range",
      "there is not enough memory",
      "the folder cannot be made or written to",
      "there is a capture in the folder already; set replace, or choose another one",
      "a file could not be written; the disk may be full",
      "no frame was begun, its number or time does not rise, or the plane or object was stated before",
      "a jitter, matrix, exposure or time is not a finite number within its range",
      "there is no plane of this name, it has another format or size, or the frame has no color",
      "a convention is not of the form key=value, or is stated twice"};
  return status >= TAA_OK && status <= TAA_ERROR_CONVENTION ? texts[status] : "unknown status";
}

#endif // TAA_CAPTURE_IMPLEMENTATION
