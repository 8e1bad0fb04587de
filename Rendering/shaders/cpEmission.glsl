// Emission without absorption along a segment on which the scalar is linear.
// Inside an interval of the transfer function colour and extinction are linear in the scalar, their
// product is quadratic: Simpson's rule is exact.

void addPiece(vec4 front, vec4 back, vec2 ends, float len, inout vec4 sum)
{
  vec4 middle = 0.5 * (front + back);
  sum.rgb += (len / 6.0) *
    (front.a * front.rgb + 4.0 * middle.a * middle.rgb + back.a * back.rgb);
}
