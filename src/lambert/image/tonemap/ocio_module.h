#pragma once
/// The function of the module lambert_ocio.so, which alone is linked to OpenColorIO.

extern "C" {

/// Names of the configuration in $OCIO; empty ones are its defaults, and the role scene_linear as input.
struct LambertOcioTransform {
  const char *display, *view, *input;
};

/// Transforms interleaved RGB in place. Returns 0, or 1 with what went wrong in `error`, ended by 0.
int lambert_ocio_apply(const LambertOcioTransform* transform, float* rgb, long width, long height, char* error,
                       unsigned long error_size);
}
