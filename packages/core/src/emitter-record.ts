export const emitterRecord = [];
export const packEmitters = () => [];
