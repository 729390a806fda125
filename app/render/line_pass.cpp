#include "render/line_pass.h"

namespace penumbra {

void LineStyles::set(int style, const glm::vec4 &colour, float width, float dash, float drawn) {
    colours[static_cast<std::size_t>(style)] = colour;
    strokes[static_cast<std::size_t>(style)] = {width, dash, drawn, 0};
}

LinePass::LinePass() : program_({"space.glsl", "line.vert"}, {"line.frag"}) {}

void LinePass::draw(const Frame &frame, const gl::TextureBuffer &segments, LineStyles styles, float lift,
                    const glm::vec4 &casing) const {
    if (segments.size() == 0)
        return;
    program_.use();
    frame.set_space(program_);
    segments.bind(1);
    program_.set("segments", 1);
    program_.set("viewport", frame.viewport);
    program_.set("near", frame.near);
    program_.set("lift", lift);
    program_.set("pixel", frame.pixel);
    for (glm::vec4 &stroke : styles.strokes) {
        stroke.x *= frame.scale;
        stroke.y *= frame.scale;
    }
    const GLsizei n_vertices = 3 * segments.size();
    if (casing.a > 0) {
        LineStyles wide = styles;
        for (glm::vec4 &colour : wide.colours)
            colour = casing;
        for (glm::vec4 &stroke : wide.strokes)
            stroke.w = 2 * frame.scale;
        program_.set("colours", wide.colours);
        program_.set("strokes", wide.strokes);
        glDrawArrays(GL_TRIANGLES, 0, n_vertices);
    }
    program_.set("colours", styles.colours);
    program_.set("strokes", styles.strokes);
    glDrawArrays(GL_TRIANGLES, 0, n_vertices);
}

} // namespace penumbra
