/** The scenes of `data/images` as they are described there; data/README.md, section 3, says what every field means. */
import type { Vec3 } from '@ray-scene/core';

export interface NeutralCamera {
  /** perspective, orthographic or thinLens. */
  readonly type: string;
  readonly origin: Vec3;
  readonly target: Vec3;
  readonly up: Vec3;
  readonly vfovDegrees?: number;
  readonly viewHeight?: number;
  readonly apertureRadius?: number;
  readonly focusDistance?: number;
}

export interface NeutralMaterial {
  /** lambert, mirror, ggxConductor, dielectric or roughDielectric. */
  readonly type: string;
  readonly albedo?: Vec3;
  readonly reflectance?: Vec3;
  readonly alpha?: number;
  readonly iorInside?: number;
  readonly iorOutside?: number;
  readonly checker?: { readonly cell: number; readonly color0: Vec3; readonly color1: Vec3 };
}

/** Which of its fields an object has depends on its shape. */
export interface NeutralObject {
  readonly shape: string;
  readonly material: string;
  readonly emission?: Vec3;
  /** outside (the default), inside or both. */
  readonly emissionSide?: string;
  readonly center?: Vec3;
  readonly radius?: number;
  readonly corner?: Vec3;
  readonly edgeU?: Vec3;
  readonly edgeV?: Vec3;
  readonly min?: Vec3;
  readonly max?: Vec3;
  readonly rotateYDegrees?: number;
  readonly a?: Vec3;
  readonly b?: Vec3;
  readonly c?: Vec3;
  readonly capped?: boolean;
  readonly point?: Vec3;
  readonly normal?: Vec3;
  readonly axis?: Vec3;
  readonly major?: number;
  readonly minor?: number;
}

export interface NeutralLight {
  /** point, spot or directional. */
  readonly type: string;
  readonly position?: Vec3;
  readonly target?: Vec3;
  readonly direction?: Vec3;
  readonly intensity?: Vec3;
  readonly irradiance?: Vec3;
  readonly cutoffDegrees?: number;
  readonly beamWidthDegrees?: number;
}

export interface NeutralEnvironment {
  /** constant or envmap. */
  readonly type: string;
  readonly radiance?: Vec3;
  readonly file?: string;
  readonly width?: number;
  readonly height?: number;
}

export interface NeutralScene {
  readonly name: string;
  readonly width: number;
  readonly height: number;
  readonly camera: NeutralCamera;
  readonly materials: { readonly [name: string]: NeutralMaterial };
  readonly objects: readonly NeutralObject[];
  readonly lights: readonly NeutralLight[];
  readonly environment: NeutralEnvironment | null;
  readonly integrator: { readonly type: string; readonly mitsubaMaxDepth?: number };
}
