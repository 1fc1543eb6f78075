// A program that is not this renderer: it draws a few triangles with OpenGL as an engine would, reads color,
// motion, depth and ids back and hands them to taa_capture.h. client FOLDER writes a capture of four frames;
// client FOLDER N dies within frame N.
// 64 × 48 px, GL's own conventions: rows from the bottom, clip space −1 to 1, depth 0 to 1 with 1 far.
#if __STDC_VERSION__ != 199901L
#error "this is a test of C99"
#endif

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TAA_CAPTURE_IMPLEMENTATION
#include "taa_capture.h"

enum { WIDTH = 64, HEIGHT = 48, FRAMES = 4 };

static const char* const vertex_shader =
    "#version 330 core\n"
    "layout(location = 0) in vec2 corner;\n"
    "uniform vec2 offset, previous_offset, jitter; // of device coordinates\n"
    "uniform float depth;\n"
    "out vec2 now, before;\n"
    "void main() {\n"
    "  now = corner + offset;\n"
    "  before = corner + previous_offset;\n"
    "  gl_Position = vec4(now + jitter, depth, 1.0);\n"
    "}\n";
static const char* const fragment_shader = "#version 330 core\n"
                                           "in vec2 now, before;\n"
                                           "uniform vec3 color;\n"
                                           "uniform uint id;\n"
                                           "layout(location = 0) out vec4 out_color;\n"
                                           "layout(location = 1) out vec2 out_motion;\n"
                                           "layout(location = 2) out uint out_id;\n"
                                           "void main() {\n"
                                           "  out_color = vec4(color, 1.0);\n"
                                           "  out_motion = now - before;\n"
                                           "  out_id = id;\n"
                                           "}\n";

static void require(int is_fine, const char* what) {
  if (is_fine) return;
  fprintf(stderr, "client: %s\n", what);
  exit(1);
}

static void make_context(void) {
  const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION,
                           3,
                           EGL_CONTEXT_MINOR_VERSION,
                           3,
                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                           EGL_NONE};
  EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
  EGLContext context;
  require(display != EGL_NO_DISPLAY && eglInitialize(display, NULL, NULL) && eglBindAPI(EGL_OPENGL_API),
          "there is no surfaceless EGL");
  context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
  require(context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context),
          "there is no OpenGL 3.3");
}

static void add_shader(GLuint program, GLenum stage, const char* source) {
  GLint is_compiled = 0;
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &source, NULL);
  glCompileShader(shader);
  glGetShaderiv(shader, GL_COMPILE_STATUS, &is_compiled);
  require(is_compiled, "a shader does not compile");
  glAttachShader(program, shader);
}

static GLuint make_program(void) {
  GLint is_linked = 0;
  const GLuint program = glCreateProgram();
  add_shader(program, GL_VERTEX_SHADER, vertex_shader);
  add_shader(program, GL_FRAGMENT_SHADER, fragment_shader);
  glLinkProgram(program);
  glGetProgramiv(program, GL_LINK_STATUS, &is_linked);
  require(is_linked, "the program does not link");
  return program;
}

static void attach(GLenum attachment, GLenum format) {
  GLuint buffer;
  glGenRenderbuffers(1, &buffer);
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorage(GL_RENDERBUFFER, format, WIDTH, HEIGHT);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
}

static void make_targets(void) {
  const GLenum targets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2};
  GLuint framebuffer;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  attach(GL_COLOR_ATTACHMENT0, GL_RGBA16F);
  attach(GL_COLOR_ATTACHMENT1, GL_RG16F);
  attach(GL_COLOR_ATTACHMENT2, GL_R16UI);
  attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F);
  glDrawBuffers(3, targets);
  require(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE,
          "the targets are not complete");
  glViewport(0, 0, WIDTH, HEIGHT);
  glEnable(GL_DEPTH_TEST);
}

static void make_triangles(void) {
  // A triangle of 16 × 16 px with its right angle at the lower left, twice: a square.
  const float w = 32.0f / WIDTH, h = 32.0f / HEIGHT;
  const float corners[] = {0, 0, w, 0, 0, h, w, 0, w, h, 0, h};
  GLuint array, buffer;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, sizeof(corners), corners, GL_STATIC_DRAW);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, NULL);
  glEnableVertexAttribArray(0);
}

// Pixels from the lower left to device coordinates.
static float ndc(float pixels, int size) {
  return 2.0f * pixels / (float)size - 1.0f;
}

static void draw_square(GLuint program, float x, float previous_x, float y, float depth, const float* color,
                        unsigned id) {
  glUniform2f(glGetUniformLocation(program, "offset"), ndc(x, WIDTH), ndc(y, HEIGHT));
  glUniform2f(glGetUniformLocation(program, "previous_offset"), ndc(previous_x, WIDTH), ndc(y, HEIGHT));
  glUniform1f(glGetUniformLocation(program, "depth"), depth);
  glUniform3fv(glGetUniformLocation(program, "color"), 1, color);
  glUniform1ui(glGetUniformLocation(program, "id"), id);
  glDrawArrays(GL_TRIANGLES, 0, 6);
}

// A red square stands at (40, 24); a green one goes right from (8, 8), four pixels a frame.
static void draw_frame(GLuint program, int frame, const float* jitter) {
  const float sky[] = {0.25f, 0.5f, 1.0f, 1.0f}, none[4] = {0}, far_away = 1.0f;
  const float red[] = {2.0f, 0.0f, 0.0f}, green[] = {0.0f, 0.5f, 0.0f};
  const GLuint nothing[4] = {0};
  const float x = 8.0f + 4.0f * (float)frame;
  glClearBufferfv(GL_COLOR, 0, sky);
  glClearBufferfv(GL_COLOR, 1, none);
  glClearBufferuiv(GL_COLOR, 2, nothing);
  glClearBufferfv(GL_DEPTH, 0, &far_away);
  glUseProgram(program);
  glUniform2f(glGetUniformLocation(program, "jitter"), 2.0f * jitter[0] / WIDTH, 2.0f * jitter[1] / HEIGHT);
  draw_square(program, 40.0f, 40.0f, 24.0f, 0.0f, red, 300);
  draw_square(program, x, frame > 0 ? x - 4.0f : x, 8.0f, -0.5f, green, 7);
}

static void need(int status) {
  require(status == TAA_OK, taa_capture_text(status));
}

static void write_plane(taa_capture* capture, const char* name, taa_format format, GLenum attachment,
                        GLenum gl_format, GLenum gl_type) {
  static char pixels[WIDTH * HEIGHT * 16];
  if (attachment) glReadBuffer(attachment);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, WIDTH, HEIGHT, gl_format, gl_type, pixels);
  need(taa_capture_plane(capture, name, format, WIDTH, HEIGHT, 0, TAA_ROWS_BOTTOM_FIRST, pixels));
}

static void write_frame(taa_capture* capture, int number, const float* jitter, int dies) {
  // Orthographic, two units wide and high and deep, rows one after another.
  const float projection[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, 0, 1};
  const double view[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  taa_capture_frame frame;
  memset(&frame, 0, sizeof(frame));
  frame.number = number;
  frame.jitter[0] = (double)jitter[0];
  frame.jitter[1] = (double)jitter[1];
  frame.view64 = frame.previous_view64 = view;
  frame.projection = frame.previous_projection = projection;
  frame.cut = number == 0;
  need(taa_capture_begin(capture, &frame));
  write_plane(capture, "color", TAA_RGBA16F, GL_COLOR_ATTACHMENT0, GL_RGBA, GL_HALF_FLOAT);
  write_plane(capture, "motion", TAA_RG16F, GL_COLOR_ATTACHMENT1, GL_RG, GL_HALF_FLOAT);
  write_plane(capture, "objectId", TAA_R16_UINT, GL_COLOR_ATTACHMENT2, GL_RED_INTEGER, GL_UNSIGNED_SHORT);
  if (dies) _Exit(3); // as an engine that crashes: nothing is closed
  write_plane(capture, "depth", TAA_D32F, 0, GL_DEPTH_COMPONENT, GL_FLOAT);
  need(taa_capture_end(capture));
}

int main(int count, char** arguments) {
  static const float jitters[FRAMES][2] = {{0, 0}, {0.25f, -0.25f}, {-0.25f, 0.125f}, {0.375f, 0.25f}};
  static const char* const conventions[] = {"motion.unit=ndc",
                                            "motion.notWritten=none",
                                            "motion.yAxis=up",
                                            "jitter.yAxis=up",
                                            "depth.reversed=false",
                                            "depth.nothing=1",
                                            "matrices.clipZ=minusOneToOne",
                                            "rows=bottomFirst",
                                            NULL};
  taa_capture_desc desc;
  taa_capture* capture = NULL;
  GLuint program;
  const int last = count == 3 ? atoi(arguments[2]) : FRAMES;
  int frame;
  require(count == 2 || count == 3, "wants the folder to write to");
  setlocale(LC_ALL, ""); // as many programs do; numbers in the capture have points all the same
  make_context();
  program = make_program();
  make_targets();
  make_triangles();
  memset(&desc, 0, sizeof(desc));
  desc.folder = arguments[1];
  desc.width = WIDTH;
  desc.height = HEIGHT;
  desc.like = "taa-inspector";
  desc.conventions = conventions;
  desc.name = "Two \"squares\"";
  desc.engine = "tests/capture_client";
  desc.frames_per_second = 30;
  need(taa_capture_open(&capture, &desc));
  need(taa_capture_object(capture, 7, "green square"));
  need(taa_capture_object(capture, 300, "red square"));
  for (frame = 0; frame < FRAMES; ++frame) {
    draw_frame(program, frame, jitters[frame]);
    write_frame(capture, frame, jitters[frame], frame == last);
  }
  require(glGetError() == GL_NO_ERROR, "OpenGL reports an error");
  need(taa_capture_close(capture));
  return 0;
}
