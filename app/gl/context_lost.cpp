#include "gl/context_lost.h"

#include <epoxy/gl.h>

namespace penumbra::gl {

bool context_is_lost() {
    if (epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_KHR_robustness"))
        return glGetGraphicsResetStatus() != GL_NO_ERROR;
    return epoxy_has_gl_extension("GL_ARB_robustness") && glGetGraphicsResetStatusARB() != GL_NO_ERROR;
}

} // namespace penumbra::gl
