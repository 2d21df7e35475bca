// A distance that no ray gets to. Lengths are packed with the largest near 1; the square of this is still a number.
const float MISS = 1e18;
// Keeps a quotient of zeros defined. A little above the smallest normal number, which some compilers make a zero of.
const float SMALLEST = 1e-37;
