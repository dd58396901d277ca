/** True if the page is used by touch, without the keys and the precision of a mouse. */
export const isTouch = () => matchMedia("(pointer: coarse)").matches;
