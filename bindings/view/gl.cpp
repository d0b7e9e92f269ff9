#include "view/gl.hpp"

#include <algorithm>
#include <iostream>
#include <utility>

#include "base/check.hpp"
#include "view/shaders.hpp"

namespace pantin {

namespace {

std::string_view shader_text(const std::string& name) {
  const auto found =
      std::find_if(shader_texts.begin(), shader_texts.end(), [&](const auto& s) { return s.name == name; });
  require(found != shader_texts.end(), "no shader is called '", name, "'");
  return found->text;
}

GLuint compile(GLenum kind, const std::string& name, const std::string& text) {
  const GLuint id = glCreateShader(kind);
  const char* source = text.c_str();
  glShaderSource(id, 1, &source, nullptr);
  glCompileShader(id);
  GLint good = 0;
  glGetShaderiv(id, GL_COMPILE_STATUS, &good);
  if (!good) {
    char why[2000] = "";
    glGetShaderInfoLog(id, sizeof why, nullptr, why);
    throw Error(pantin::text("shader '", name, "': ", why));
  }
  return id;
}

struct TextureKind {
  GLint inside;
  GLenum channels, type;
  GLint between;
};

TextureKind kind_of(Target::Format format) {
  switch (format) {
    case Target::Format::height: return {GL_R32F, GL_RED, GL_FLOAT, GL_NEAREST};
    case Target::Format::shelter: return {GL_RG16F, GL_RG, GL_FLOAT, GL_NEAREST};
    default: return {GL_R8, GL_RED, GL_UNSIGNED_BYTE, GL_LINEAR};
  }
}

GLuint make_texture(const TextureKind& kind, int width, int height) {
  GLuint id = 0;
  glGenTextures(1, &id);
  glBindTexture(GL_TEXTURE_2D, id);
  glTexImage2D(GL_TEXTURE_2D, 0, kind.inside, width, height, 0, kind.channels, kind.type, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, kind.between);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, kind.between);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return id;
}

}  // namespace

ShaderProgram::ShaderProgram(const std::string& name, std::initializer_list<const char*> common,
                             const std::string& definitions) {
  try {
    std::string head = definitions;
    for (const char* file : common) head += shader_text(file);
    link(name, head);
  } catch (const Error& error) {
    if (id_) glDeleteProgram(std::exchange(id_, 0));
    std::cerr << "pantin: " << error.what() << "\npantin: the picture lacks what it draws\n";
  }
}

void ShaderProgram::link(const std::string& name, const std::string& head) {
  const auto text_of = [&](const char* start, const char* ending) {
    return std::string("#version 330 core\n") + start + head + std::string(shader_text(name + ending));
  };
  const GLuint vertex = compile(GL_VERTEX_SHADER, name + ".vert", text_of("", ".vert"));
  const GLuint fragment = compile(GL_FRAGMENT_SHADER, name + ".frag", text_of("#define FRAGMENT\n", ".frag"));
  id_ = glCreateProgram();
  glAttachShader(id_, vertex);
  glAttachShader(id_, fragment);
  glLinkProgram(id_);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint good = 0;
  glGetProgramiv(id_, GL_LINK_STATUS, &good);
  if (good) return;
  char why[2000] = "";
  glGetProgramInfoLog(id_, sizeof why, nullptr, why);
  throw Error(text("shader '", name, "': ", why));
}

ShaderProgram::~ShaderProgram() { glDeleteProgram(id_); }

FloatRows::FloatRows(std::initializer_list<int> attributes, bool each_instance) : each_instance_(each_instance) {
  glGenVertexArrays(1, &array_);
  glGenBuffers(1, &buffer_);
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  int total = 0;
  for (const int n : attributes) total += n;
  GLuint index = 0;
  std::size_t offset = 0;
  for (const int n : attributes) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, n, GL_FLOAT, GL_FALSE, total * static_cast<int>(sizeof(float)),
                          reinterpret_cast<const void*>(offset));
    if (each_instance) glVertexAttribDivisor(index, 1);
    offset += static_cast<std::size_t>(n) * sizeof(float);
    index++;
  }
}

FloatRows::~FloatRows() {
  glDeleteBuffers(1, &buffer_);
  glDeleteVertexArrays(1, &array_);
}

void FloatRows::draw(const ShaderProgram& program, GLenum shape, GLsizei corners) const {
  if (!program.usable()) return;
  program.use();
  glBindVertexArray(array_);
  if (each_instance_)
    glDrawArraysInstanced(shape, 0, corners, count_);
  else
    glDrawArrays(shape, 0, corners > 0 ? corners : count_);
}

void FloatRows::send(const void* data, std::size_t bytes) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
}

Target::Target(int width, int height, int samples, Format format, Depth depth)
    : width_(width), height_(height), texture_(format != Format::color), depth_kind_(depth) {
  GLint most = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  samples_ = std::clamp(samples, 0, static_cast<int>(most));
  glGenFramebuffers(1, &framebuffer_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  add_color(format);
  if (depth != Depth::none) add_depth();
  require(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE, "OpenGL gives no picture of ", width,
          " x ", height, " pixels with ", samples_, " samples");
}

void Target::add_color(Format format) {
  if (texture_) {
    const TextureKind kind = kind_of(format);
    color_ = make_texture(kind, width_, height_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_, 0);
  } else {
    glGenRenderbuffers(1, &color_);
    glBindRenderbuffer(GL_RENDERBUFFER, color_);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_RGBA8, width_, height_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_);
  }
}

void Target::add_depth() {
  if (depth_kind_ == Depth::texture) {
    depth_ = make_texture({GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, GL_NEAREST}, width_, height_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
  } else {
    glGenRenderbuffers(1, &depth_);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_DEPTH_COMPONENT24, width_, height_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  }
}

Target::~Target() {
  glDeleteFramebuffers(1, &framebuffer_);
  if (texture_)
    glDeleteTextures(1, &color_);
  else
    glDeleteRenderbuffers(1, &color_);
  if (depth_kind_ == Depth::texture)
    glDeleteTextures(1, &depth_);
  else
    glDeleteRenderbuffers(1, &depth_);
}

void Target::bind_texture(int unit) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, color_);
  glActiveTexture(GL_TEXTURE0);
}

void Target::bind_depths(int unit) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, depth_);
  glActiveTexture(GL_TEXTURE0);
}

void Target::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, width_, height_);
}

}  // namespace pantin
