// A distance that no ray gets to. Lengths are packed with the largest near 1; the square of this is still a number.
const float MISS = 1e18;
// Keeps a quotient of zeros defined. A little above the smallest normal number, which some compilers make a zero of.
const float SMALLEST = 1e-37;
// Radiance above this is cut off, so that sums of samples stay numbers: next to a lamp it has no bounds.
const float LARGEST = 1e30;
