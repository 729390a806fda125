#include "plot/plot_picture.h"

#include "core/error.h"
#include "gl/bound_framebuffer.h"
#include "gl/context_lost.h"
#include "gl/framebuffer.h"
#include "plot/draw_list_canvas.h"
#include "render/overlay.h"

namespace penumbra {

Image draw_plot_picture(int width, int height, float text, Theme theme, const std::function<void(Canvas &)> &draw) {
    const gl::BoundFramebuffer before;
    const gl::Framebuffer picture(width, height, gl::Framebuffer::Colour::srgb8, 1);
    Overlay overlay(width, height, text);
    picture.bind();
    const glm::vec4 ground = background_colour(theme);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(ground.r, ground.g, ground.b, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    DrawListCanvas canvas(overlay.list(), overlay.fonts());
    draw(canvas);
    overlay.draw({0, 0, width, height});
    picture.bind();
    Image image = read_pixels(0, 0, width, height);
    if (gl::context_is_lost())
        throw Unavailable("the graphics driver has lost what the plot was drawn with; try again");
    return image;
}

} // namespace penumbra
