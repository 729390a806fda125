#include "window/glfw_window.h"

#include "core/error.h"
#include "window/keys.h"

#include <epoxy/gl.h>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <string_view>
#include <utility>

namespace penumbra {

namespace {
std::string glfw_words() {
    const char *words = nullptr;
    glfwGetError(&words);
    return words ? words : "no reason given";
}
} // namespace

/// ImGui's back end installs its own callbacks over these and passes every event on.
struct GlfwWindow::Callbacks {
    static GlfwWindow &of(GLFWwindow *window) { return *static_cast<GlfwWindow *>(glfwGetWindowUserPointer(window)); }

    static void key(GLFWwindow *window, int key, int scancode, int action, int mods) {
        GlfwWindow &self = of(window);
        self.touched_ = true;
        if (action == GLFW_RELEASE) {
            self.events_.release(key_word(key, scancode, 0));
            return;
        }
        self.pressed_.push_back(key);
        const std::string word = key_word(key, scancode, mods);
        const bool edits = word.size() == 6 && word.starts_with("Ctrl+") && std::string_view("ACVXYZ").find(word.back()) != std::string_view::npos;
        const bool text = ImGui::GetIO().WantTextInput && (edits || !(mods & GLFW_MOD_CONTROL)) && word != "Escape" &&
                          !(key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12);
        if (!word.empty() && !text)
            self.events_.key(word);
    }
    static void character(GLFWwindow *window, unsigned int codepoint) {
        GlfwWindow &self = of(window);
        self.touched_ = true;
        const std::string word = text_key(codepoint);
        if (!word.empty() && !ImGui::GetIO().WantTextInput)
            self.events_.key(word);
    }
    static void drop(GLFWwindow *window, int n, const char **files) {
        of(window).touched_ = true;
        if (n > 0)
            of(window).events_.drop(files[0]);
    }
    static void touch(GLFWwindow *window) { of(window).touched_ = true; }
};

GlfwWindow::GlfwWindow(const std::string &title, int width, int height, Events events) : events_(std::move(events)) {
    if (!glfwInit())
        throw Unavailable("no window: " + glfw_words());
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    // So that a lost context is told of; a driver that has none such gives a plain one.
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);
    window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (!window_) {
        glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_NO_ROBUSTNESS);
        window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    }
    if (!window_) {
        const std::string words = glfw_words();
        glfwTerminate();
        throw Unavailable("no window with OpenGL 4.1: " + words);
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    glfwSetWindowSizeLimits(window_, 480, 320, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, Callbacks::key);
    glfwSetCharCallback(window_, Callbacks::character);
    glfwSetDropCallback(window_, Callbacks::drop);
    glfwSetCursorPosCallback(window_, [](GLFWwindow *w, double, double) { Callbacks::touch(w); });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow *w, int, int, int) { Callbacks::touch(w); });
    glfwSetScrollCallback(window_, [](GLFWwindow *w, double, double) { Callbacks::touch(w); });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow *w, int) { Callbacks::touch(w); });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow *w, int) { Callbacks::touch(w); });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow *w, int, int) { Callbacks::touch(w); });
    glfwSetWindowRefreshCallback(window_, Callbacks::touch);

    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr; // nothing is littered into the working folder
    ImGui::GetIO().LogFilename = nullptr;
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    ImGui_ImplOpenGL3_Init("#version 410");
}

GlfwWindow::~GlfwWindow() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

bool GlfwWindow::should_close() const { return glfwWindowShouldClose(window_); }

void GlfwWindow::wait(double seconds) {
    if (seconds < 0)
        glfwWaitEvents();
    else if (seconds == 0)
        glfwPollEvents();
    else
        glfwWaitEventsTimeout(seconds);
}

bool GlfwWindow::take_touched() { return std::exchange(touched_, false); }

bool GlfwWindow::has_input_waiting() const {
#if IMGUI_VERSION_NUM < 18700
    return false;
#else
    return ImGui::GetCurrentContext()->InputEventsQueue.Size > 0;
#endif
}

void GlfwWindow::wake() { glfwPostEmptyEvent(); }

double GlfwWindow::pixel_ratio() const {
    int window_width = 0, window_height = 0, width = 0, height = 0;
    glfwGetWindowSize(window_, &window_width, &window_height);
    glfwGetFramebufferSize(window_, &width, &height);
    return window_width > 0 && width > 0 ? static_cast<double>(width) / window_width : 1;
}

double GlfwWindow::content_scale() const {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    // Where a screen coordinate is more than a pixel, the system has scaled already.
    return static_cast<double>(x) / pixel_ratio();
}

void GlfwWindow::framebuffer_size(int &width, int &height) const { glfwGetFramebufferSize(window_, &width, &height); }

void GlfwWindow::begin_frame() {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    show_short_presses();
    ImGui::NewFrame();
}

/// ImGui before 1.87 looks only at the state of the keys when a frame begins: one that went down and up again since the
/// last frame must be held for it until the next.
void GlfwWindow::show_short_presses() {
#if IMGUI_VERSION_NUM < 18700
    bool *down = ImGui::GetIO().KeysDown;
    for (int key = 0; key <= GLFW_KEY_LAST; ++key)
        if (down[key] && glfwGetKey(window_, key) == GLFW_RELEASE)
            down[key] = false;
    for (const int key : pressed_)
        if (key >= 0 && key <= GLFW_KEY_LAST)
            down[key] = true;
#endif
    pressed_.clear();
}

void GlfwWindow::draw_interface() {
    drawn_ = true;
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void GlfwWindow::swap() { glfwSwapBuffers(window_); }

void GlfwWindow::replace_fonts(const std::function<void()> &load) {
    if (!drawn_) { // the first frame makes the texture by itself
        load();
        return;
    }
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui::GetIO().Fonts->Clear();
    load();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

} // namespace penumbra
