// taa_capture.h: writes what a frame of your engine is made of, so that TAA Inspector can open it. One file
// for C99 and C++ that needs the C library alone: in ONE source file define TAA_CAPTURE_IMPLEMENTATION before
// you include it. The manual's page "Frames out of an engine" has an example, and says what to hand over.
//
// Planes are written as they lie in memory, on little-endian machines; there are whole files only. A call
// blocks for its own writes and for nothing else; plane takes no memory. Functions of one capture are called
// by one thread at a time. What TAA Inspector would refuse to open is an error here, but for keys and values
// of `like` and `conventions`, which it names. After an error the capture can still be used: a plane that
// failed is not part of it, nor is a frame whose color failed. After a crash it has the frames that were
// ended.
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
  // Whose conventions are yours: taa-inspector, unreal, unity, godot, bevy, three, babylon, fsr, xess,
  // streamline, metalfx or blender.
  const char* like;
  const char* const* conventions; // "key=value" where you differ, NULL after the last one
  const char *name, *engine;      // for people
  double frames_per_second;       // 0.001 to 100000; 0: 60
  int replace;                    // 1: a capture that is there is replaced; 0: TAA_ERROR_EXISTS
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
// Ends the frame if it was not, and frees the capture whatever it returns; NULL is fine.
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
#define taa_replace(from, to) (remove(to), rename(from, to)) // rename replaces nothing there
#else
#include <sys/stat.h>
#define taa_make_folder(path) mkdir(path, 0777)
#define taa_replace(from, to) rename(from, to)
#endif

// clang-format off
enum { TAA_COLOR = 0, TAA_OUTPUT = 9, TAA_PLANES = 11, TAA_FORMATS = 20, TAA_MOST_BYTES = 4096 }; // bytes of a text
// Channels that a plane needs and a format has; 0: a whole number.
static const struct { const char* name; int channels; } taa_planes[TAA_PLANES] = {
  {"color", 3}, {"motion", 2}, {"depth", 1}, {"objectId", 0}, {"normal", 3}, {"previousDepth", 1}, {"mask", 1},
  {"overlay", 4}, {"fog", 3}, {"output", 3}, {"reference", 3}};
static const struct { const char* name; unsigned bytes; int channels; } taa_formats[TAA_FORMATS] = {
  {"R11G11B10F", 4, 3}, {"RGBA16F", 8, 4}, {"RGBA32F", 16, 4}, {"RG16F", 4, 2}, {"RG32F", 8, 2}, {"RG16_UNORM", 4, 2},
  {"RGBA8_UNORM", 4, 4}, {"RGBA8_SRGB", 4, 4}, {"R16F", 2, 1}, {"R32F", 4, 1}, {"D32F", 4, 1}, {"D24S8", 4, 1},
  {"D32F_S8", 8, 1}, {"R16_UNORM", 2, 1}, {"R8_UNORM", 1, 1}, {"RG8_UNORM", 2, 2}, {"R8_UINT", 1, 0}, {"R16_UINT", 2, 0},
  {"R32_UINT", 4, 0}, {"D24S8_GL", 4, 1}};
// clang-format on

typedef struct taa_text {
  char* at;
  size_t length, room;
} taa_text;

struct taa_capture {
  taa_capture_desc desc; // with its defaults; its texts are the caller's
  char folder[TAA_MOST_BYTES];
  taa_text head, frames;       // of capture.json: up to its objects; its frames
  size_t ended;                // bytes of `frames` that are of frames that were ended
  taa_capture_frame now, last; // their numbers and times: begun last, ended last
  int is_open;
  unsigned planes, largest_id; // planes: of the frame, one bit for each kind
};

// Room for so many bytes more: nothing is printed without.
static int taa_reserve(taa_text* text, size_t bytes) {
  char* const at = (char*)realloc(text->at, text->length + bytes);
  if (!at) return TAA_ERROR_MEMORY;
  text->at = at;
  text->room = text->length + bytes;
  return TAA_OK;
}

// As printf; no number but whole ones, as locales have points of their own.
static void taa_print(taa_text* text, const char* format, ...) {
  va_list values;
  va_start(values, format);
  text->length += (size_t)vsnprintf(text->at + text->length, text->room - text->length, format, values);
  va_end(values);
}

// Bytes of the UTF-8 letter at `at`, 0 where there is none.
static size_t taa_letter(const unsigned char* at) {
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

// Control characters become spaces, bytes that are not UTF-8 question marks, and it ends where it is too
// long.
static int taa_print_string(taa_text* to, const char* before, const char* string) {
  const unsigned char* at = (const unsigned char*)string;
  const unsigned char* const end = at + TAA_MOST_BYTES;
  int status = taa_reserve(to, 2 * TAA_MOST_BYTES + 256);
  if (status) return status;
  taa_print(to, "%s\"", before);
  for (size_t letter = taa_letter(at); *at && at < end && at + letter <= end; letter = taa_letter(at)) {
    const int is_control = *at < 0x20 || *at == 0x7f || (*at == 0xc2 && letter == 2 && at[1] < 0xa0);
    if (*at == '"' || *at == '\\') taa_print(to, "\\");
    taa_print(to, "%.*s", letter ? (int)letter : 1, !letter ? "?" : is_control ? " " : (const char*)at);
    at += letter ? letter : 1;
  }
  taa_print(to, "\"");
  return TAA_OK;
}

// What capture.json states by `key`: some numbers, or one. Whatever setlocale() was told, the locale's
// decimal point is all that is no digit, sign or exponent; letters tell, as -ffast-math takes isfinite()
// away.
static int taa_print_numbers(taa_text* to, const char* key, int count, const float* floats,
                             const double* doubles, double most) {
  for (int i = 0; i < count && (floats || doubles); ++i) {
    const double number = doubles ? doubles[i] : (double)floats[i];
    char text[64];
    size_t whole, point;
    snprintf(text, sizeof(text), "%.*g", doubles ? 17 : 9, number);
    if (strpbrk(text, "nN") || number < -most || number > most) return TAA_ERROR_NUMBER; // nan, inf
    whole = strspn(text, "0123456789+-e");
    point = strcspn(text + whole, "0123456789+-e");
    taa_print(to, i ? ", " : ", \"%s\": %s", key, count > 1 ? "[" : "");
    taa_print(to, "%.*s%s%s%s", (int)whole, text, point ? "." : "", text + whole + point,
              i > 0 && i == count - 1 ? "]" : "");
  }
  return TAA_OK;
}

// FOLDER/name, whole or as it was before: some bytes, and a text behind them.
static int taa_write(taa_capture* capture, const char* name, const void* bytes, size_t count,
                     const taa_text* text) {
  char part[TAA_MOST_BYTES + 64], whole[TAA_MOST_BYTES + 64];
  FILE* file;
  int written;
  snprintf(part, sizeof(part), "%s/.taa_capture.part", capture->folder);
  snprintf(whole, sizeof(whole), "%s/%s", capture->folder, name);
  file = fopen(part, "wb");
  if (!file) return TAA_ERROR_FOLDER;
  written = fwrite(bytes, 1, count, file) == count;
  written = written && (!text || fwrite(text->at, 1, text->length, file) == text->length);
  written = fclose(file) == 0 && written;
  if (written && taa_replace(part, whole) == 0) return TAA_OK;
  remove(part);
  return TAA_ERROR_WRITE;
}

// With the frames that were ended, while none is open.
static int taa_write_manifest(taa_capture* capture) {
  capture->frames.length = capture->ended;
  taa_print(&capture->frames, "\n ]\n}\n");
  return taa_write(capture, "capture.json", capture->head.at, capture->head.length, &capture->frames);
}

static int taa_is_size(int width, int height) {
  return width >= 1 && width <= 16384 && height >= 1 && height <= 16384 &&
         (size_t)width * (size_t)height <= (size_t)1 << 26;
}

// What stands before the first object, and between objects and frames.
static int taa_begin_manifest(taa_text* head, taa_text* frames, const taa_capture_desc* desc) {
  const char* const texts[] = {
      ",\n \"name\": ", desc->name, ",\n \"engine\": ", desc->engine, ",\n \"like\": ", desc->like};
  const char* const* given = desc->conventions;
  int status = taa_reserve(head, 512) || taa_reserve(frames, 64) ? TAA_ERROR_MEMORY : TAA_OK;
  if (status) return status;
  taa_print(frames, "},\n \"frames\": [");
  taa_print(head, "{\n \"format\": 1,\n \"size\": [%d, %d],\n \"outputSize\": [%d, %d]", desc->width,
            desc->height, desc->output_width, desc->output_height);
  status = taa_print_numbers(head, "framesPerSecond", 1, NULL, &desc->frames_per_second, 1e5);
  for (int i = 0; i < 6 && !status; i += 2)
    if (texts[i + 1]) status = taa_print_string(head, texts[i], texts[i + 1]);
  for (int i = 0; given && given[i] && !status; ++i) {
    const size_t key = strcspn(given[i], "=");
    if (key == 0 || !given[i][key] || !given[i][key + 1]) return TAA_ERROR_CONVENTION;
    for (int k = 0; k < i; ++k)
      if (strncmp(given[k], given[i], key + 1) == 0) return TAA_ERROR_CONVENTION;
    status = taa_print_string(head, i ? ", " : ",\n \"conventions\": [", given[i]);
  }
  if (!status) taa_print(head, "%s,\n \"objects\": {", given && *given ? "]" : "");
  return status;
}

// Makes the folder, and a capture of no frames in it: a folder that cannot be written to says so now, and the
// capture that was there would name the new one's planes.
static int taa_make_capture_folder(taa_capture* capture) {
  char manifest[TAA_MOST_BYTES + 64];
  FILE* file;
  if (strlen(capture->desc.folder) >= sizeof(capture->folder)) return TAA_ERROR_FOLDER;
  strcpy(capture->folder, capture->desc.folder);
  taa_make_folder(capture->folder);
  snprintf(manifest, sizeof(manifest), "%s/capture.json", capture->folder);
  file = fopen(manifest, "rb");
  if (file) fclose(file);
  return file && !capture->desc.replace ? TAA_ERROR_EXISTS : taa_write_manifest(capture);
}

static int taa_free(taa_capture* capture, int status) {
  free(capture->head.at);
  free(capture->frames.at);
  free(capture);
  return status;
}

int taa_capture_open(taa_capture** capture, const taa_capture_desc* desc) {
  taa_capture* opened;
  taa_capture_desc stated;
  int status;
  if (!capture) return TAA_ERROR_ARGUMENT;
  *capture = NULL;
  if (!desc || !desc->folder || !*desc->folder) return TAA_ERROR_ARGUMENT;
  stated = *desc;
  if (!desc->output_width && !desc->output_height)
    stated.output_width = desc->width, stated.output_height = desc->height;
  if (desc->frames_per_second == 0) stated.frames_per_second = 60;
  if (!taa_is_size(stated.width, stated.height) || !taa_is_size(stated.output_width, stated.output_height) ||
      stated.frames_per_second < 1e-3)
    return TAA_ERROR_ARGUMENT;
  opened = (taa_capture*)calloc(1, sizeof(taa_capture));
  if (!opened) return TAA_ERROR_MEMORY;
  opened->desc = stated;
  opened->now.number = opened->last.number = -1;
  status = taa_begin_manifest(&opened->head, &opened->frames, &stated);
  opened->ended = opened->frames.length;
  if (!status) status = taa_make_capture_folder(opened);
  if (status) return taa_free(opened, status);
  *capture = opened;
  return TAA_OK;
}

// A frame up to its planes, which have room behind it.
static int taa_print_frame(taa_text* text, const taa_capture_frame* frame) {
  // clang-format off
  const struct { const char* key; int count; double most; const float* floats; const double* doubles; } all[] = {
    {"jitter", 2, 1e6, NULL, frame->jitter},
    {"view", 16, 1e30, frame->view, frame->view64},
    {"projection", 16, 1e30, frame->projection, frame->projection64},
    {"previousView", 16, 1e30, frame->previous_view, frame->previous_view64},
    {"previousProjection", 16, 1e30, frame->previous_projection, frame->previous_projection64},
    {"preExposure", 1, 1e12, NULL, frame->pre_exposure != 0 ? &frame->pre_exposure : NULL},
    {"seconds", 1, 1e9, NULL, frame->has_seconds ? &frame->seconds : NULL}};
  // clang-format on
  int status = taa_reserve(text, 8192);
  if (status) return status;
  taa_print(text, "%s\n  {\"number\": %d", text->at[text->length - 1] == '[' ? "" : ",", frame->number);
  for (size_t i = 0; i < sizeof(all) / sizeof(all[0]) && !status; ++i)
    status = taa_print_numbers(text, all[i].key, all[i].count, all[i].floats, all[i].doubles, all[i].most);
  taa_print(text, "%s, \"planes\": {", frame->cut ? ", \"cut\": true" : "");
  return status;
}

int taa_capture_begin(taa_capture* capture, const taa_capture_frame* frame) {
#define TAA_HAS(matrix) (frame->matrix || frame->matrix##64)
  int status;
  if (!capture || !frame || frame->number < 0 || TAA_HAS(view) != TAA_HAS(projection) ||
      TAA_HAS(previous_view) != TAA_HAS(previous_projection) || (TAA_HAS(previous_view) && !TAA_HAS(view)))
    return TAA_ERROR_ARGUMENT;
#undef TAA_HAS
  status = taa_capture_end(capture);
  if (status && status != TAA_ERROR_ORDER) return status;
  if (frame->number <= capture->now.number ||
      (capture->last.number >= 0 && (!frame->has_seconds != !capture->last.has_seconds ||
                                     (frame->has_seconds && !(frame->seconds > capture->last.seconds)))))
    return TAA_ERROR_ORDER;
  if (frame->pre_exposure != 0 && frame->pre_exposure < 1e-12) return TAA_ERROR_NUMBER;
  capture->frames.length = capture->ended; // a frame that is none is forgotten
  status = taa_print_frame(&capture->frames, frame);
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
  size_t row, pitch;
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
  snprintf(file, sizeof(file), "%s.%04d.raw", name, capture->now.number);
  // Nothing behind the last pixel is read.
  status = taa_write(capture, file, pixels, pitch * (size_t)(height - 1) + row, NULL);
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
  int status;
  if (!capture || !name || id == 0) return TAA_ERROR_ARGUMENT;
  snprintf(key, sizeof(key), ", \"%u\": ", id); // nowhere within a name, whose quotes are escaped
  if (id <= capture->largest_id && strstr(capture->head.at, key + 2)) return TAA_ERROR_ORDER;
  status = taa_print_string(&capture->head, capture->largest_id ? key : key + 2, name);
  if (!status && id > capture->largest_id) capture->largest_id = id;
  return status;
}

int taa_capture_close(taa_capture* capture) {
  int status, written;
  if (!capture) return TAA_OK;
  status = taa_capture_end(capture);
  written = taa_write_manifest(capture); // objects may have been named since the last frame ended
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
