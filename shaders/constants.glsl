// A distance that no ray gets to. Lengths are packed with the largest near 1; the square of this is still a number.
const float MISS = 1e18;
// The smallest normal number: keeps a quotient of zeros defined.
const float SMALLEST = 1.17549435e-38;
