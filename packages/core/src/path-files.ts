export const pathFiles = {};
