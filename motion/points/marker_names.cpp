#include "motion/points/marker_names.h"

namespace mien::motion {

namespace {

using enum Landmark;

// Vicon's Plug-in Gait (Davis et al. 1991; Kadaba et al. 1990).
constexpr MarkerName plug_in_gait[] = {
    {"*FHD", head_front},
    {"*BHD", head_back},
    {"C7", cervical_7},
    {"T10", back},
    {"CLAV", jugular_notch},
    {"STRN", sternum},
    {"RBAK", trunk},
    {"*SHO", acromion},
    {"*UPA", upper_arm},
    {"*ELB", outer_elbow},
    {"*FRA", forearm},
    {"*WRA", thumb_side_of_wrist},
    {"*WRB", finger_side_of_wrist},
    {"*FIN", hand},
    {"*ASI", front_iliac_spine},
    {"*PSI", back_iliac_spine},
    {"SACR", sacrum},
    {"*THI", thigh},
    {"*KNE", outer_knee},
    {"*TIB", shank},
    {"*ANK", outer_ankle},
    {"*HEE", heel},
    {"*TOE", second_metatarsal},
};

// The 41 markers of the Carnegie Mellon University motion capture database.
constexpr MarkerName cmu[] = {
    {"*FHD", head_front},
    {"*BHD", head_back},
    {"C7", cervical_7},
    {"T10", back},
    {"CLAV", jugular_notch},
    {"STRN", sternum},
    {"RBAC", trunk},
    {"*SHO", acromion},
    {"*UPA", upper_arm},
    {"*ELB", outer_elbow},
    {"*FRM", forearm},
    {"*WRA", thumb_side_of_wrist},
    {"*WRB", finger_side_of_wrist},
    {"*FIN", hand},
    {"*FWT", front_iliac_spine},
    {"*BWT", back_iliac_spine},
    {"*THI", thigh},
    {"*KNE", outer_knee},
    {"*SHN", shank},
    {"*ANK", outer_ankle},
    {"*HEE", heel},
    {"*TOE", second_metatarsal},
    {"*MT5", fifth_metatarsal},
};

// Istituto Ortopedico Rizzoli (Leardini et al. 2007, 2011).
constexpr MarkerName rizzoli[] = {
    {"*IAS", front_iliac_spine},
    {"*IPS", back_iliac_spine},
    {"*FTC", trochanter},
    {"*FLE", outer_knee},
    {"*FME", inner_knee},
    {"*FAX", shank},
    {"*TTC", shank},
    {"*FAL", outer_ankle},
    {"*TAM", inner_ankle},
    {"*FCC", heel},
    {"*FM1", first_metatarsal},
    {"*FM2", second_metatarsal},
    {"*FM5", fifth_metatarsal},
    {"*SAE", acromion},
    {"*HLE", outer_elbow},
    {"*HME", inner_elbow},
    {"*RSP", thumb_side_of_wrist},
    {"*USP", finger_side_of_wrist},
    {"*HM2", hand},
    {"CV7", cervical_7},
    {"TV2", trunk},
    {"TV7", trunk},
    {"TV10", back},
    {"MAI", trunk},
    {"SJN", jugular_notch},
    {"SXS", sternum},
    {"SGL", nose},
    {"*HDF", head_front},
};

// The gait models of OpenSim (gait2354, gait2392, Rajagopal's and Hamner's examples).
constexpr MarkerName opensim[] = {
    {"*.ASIS", front_iliac_spine},
    {"*.PSIS", back_iliac_spine},
    {"V.Sacral", sacrum},
    {"S2", sacrum},
    {"Sternum", jugular_notch},
    {"*.Clavicle", jugular_notch},
    {"*.Acromium", acromion},
    {"*.Acromion", acromion},
    {"*.Shoulder", acromion},
    {"*.Bicep", upper_arm},
    {"*.Biceps", upper_arm},
    {"*.Elbow", outer_elbow},
    {"*.Elbow.Lat", outer_elbow},
    {"*.Elbow.Med", inner_elbow},
    {"*.Forearm", forearm},
    {"*.Wrist", finger_side_of_wrist},
    {"*.Wrist.Lat", finger_side_of_wrist},
    {"*.Wrist.Med", thumb_side_of_wrist},
    {"Top.Head", head_top},
    {"*.Temple", head_side},
    {"*.Thigh.Upper", thigh},
    {"*.Thigh.Front", thigh},
    {"*.Thigh.Rear", thigh},
    {"*.TH1", thigh},
    {"*.TH2", thigh},
    {"*.TH3", thigh},
    {"*.TH4", thigh},
    {"*.Knee", outer_knee},
    {"*.Knee.Lat", outer_knee},
    {"*.Knee.Med", inner_knee},
    {"*.Shank.Upper", shank},
    {"*.Shank.Front", shank},
    {"*.Shank.Rear", shank},
    {"*.SH1", shank},
    {"*.SH2", shank},
    {"*.SH3", shank},
    {"*.SH4", shank},
    {"*.Ankle", outer_ankle},
    {"*.Ankle.Lat", outer_ankle},
    {"*.Ankle.Med", inner_ankle},
    {"*.Heel", heel},
    {"*.Midfoot.Sup", foot},
    {"*.Midfoot.Lat", foot},
    {"*.Toe", toe_tip},
    {"*.Toe.Tip", toe_tip},
    {"*.Toe.Lat", fifth_metatarsal},
    {"*.Toe.Med", first_metatarsal},
    {"*.MT5", fifth_metatarsal},
};

// OptiTrack's markers of a skeleton: Baseline (37, 41 with heels and tips of the toes) and its
// variants.
constexpr MarkerName optitrack_baseline[] = {
    {"HeadTop", head_top},
    {"HeadFront", head_front},
    {"HeadSide", head_side},
    {"BackTop", cervical_7},
    {"BackLeft", trunk},
    {"BackRight", trunk},
    {"Chest", sternum},
    {"*ShoulderTop", acromion},
    {"*ShoulderBack", trunk},
    {"*UArmHigh", upper_arm},
    {"*ElbowOut", outer_elbow},
    {"*WristIn", thumb_side_of_wrist},
    {"*WristOut", finger_side_of_wrist},
    {"*HandOut", hand},
    {"*HandIn", hand},
    {"Waist*Front", front_iliac_spine},
    {"Waist*Back", back_iliac_spine},
    {"*Thigh", thigh},
    {"*KneeOut", outer_knee},
    {"*KneeIn", inner_knee},
    {"*Shin", shank},
    {"*AnkleOut", outer_ankle},
    {"*AnkleIn", inner_ankle},
    {"*Heel", heel},
    {"*ToeIn", first_metatarsal},
    {"*ToeOut", fifth_metatarsal},
    {"*ToeTip", toe_tip},
};

// The sets of Qualisys for sports and animation, with or without "Q_" before each name.
constexpr MarkerName qualisys[] = {
    {"Head*", head_side},
    {"HeadFront", head_front},
    {"HeadTop", head_top},
    {"SpineTop", cervical_7},
    {"SpineThoracic2", cervical_7},
    {"SpineThoracic12", back},
    {"Chest", jugular_notch},
    {"ChestLow", sternum},
    {"Back*", trunk},
    {"*ShoulderTop", acromion},
    {"*ShoulderBack", trunk},
    {"*Arm", upper_arm},
    {"*ArmHigh", upper_arm},
    {"*ElbowOut", outer_elbow},
    {"*ElbowIn", inner_elbow},
    {"*WristIn", thumb_side_of_wrist},
    {"*WristOut", finger_side_of_wrist},
    {"*Hand2", hand},
    {"*HandOut", hand},
    {"*HandIn", hand},
    {"Waist*Front", front_iliac_spine},
    {"Waist*Back", back_iliac_spine},
    {"Waist*", iliac_crest},
    {"WaistBack", sacrum},
    {"*Sips", back_iliac_spine},
    {"*ThighFrontLow", thigh},
    {"*ThighHigh", thigh},
    {"*ThighLow", thigh},
    {"*KneeOut", outer_knee},
    {"*KneeIn", inner_knee},
    {"*ShinFrontHigh", shank},
    {"*ShinFrontLow", shank},
    {"*ShinSide", shank},
    {"*AnkleOut", outer_ankle},
    {"*AnkleIn", inner_ankle},
    {"*HeelBack", heel},
    {"*Forefoot1", first_metatarsal},
    {"*Forefoot2", second_metatarsal},
    {"*Forefoot5", fifth_metatarsal},
    {"*ForefootIn", first_metatarsal},
    {"*ForefootOut", fifth_metatarsal},
    {"*ToeTip", toe_tip},
};

// The markers that OpenCap and Pose2Sim estimate from keypoints (Uhlrich et al. 2023).
constexpr MarkerName opencap[] = {
    {"*.ASIS_study", front_iliac_spine},
    {"*.PSIS_study", back_iliac_spine},
    {"*HJC_study", hip},
    {"C7_study", cervical_7},
    {"*_shoulder_study", acromion},
    {"*_lelbow_study", outer_elbow},
    {"*_melbow_study", inner_elbow},
    {"*_lwrist_study", thumb_side_of_wrist},
    {"*_mwrist_study", finger_side_of_wrist},
    {"*_thigh1_study", thigh},
    {"*_thigh2_study", thigh},
    {"*_thigh3_study", thigh},
    {"*_knee_study", outer_knee},
    {"*_mknee_study", inner_knee},
    {"*_sh1_study", shank},
    {"*_sh2_study", shank},
    {"*_sh3_study", shank},
    {"*_ankle_study", outer_ankle},
    {"*_mankle_study", inner_ankle},
    {"*_calc_study", heel},
    {"*_toe_study", second_metatarsal},
    {"*_5meta_study", fifth_metatarsal},
};

// The first 22 joints of SMPL, SMPL-H and SMPL-X, in the order of HumanML3D.
constexpr MarkerName smpl[] = {
    {"pelvis", pelvis}, {"*hip", hip},         {"spine1", spine}, {"*knee", knee},
    {"spine2", chest},  {"*ankle", ankle},     {"spine3", trunk}, {"*foot", toe},
    {"neck", neck},     {"*collar", clavicle}, {"head", head},    {"*shoulder", shoulder},
    {"*elbow", elbow},  {"*wrist", wrist},     {"*hand", hand},
};

// Human3.6M with 17 joints: the "foot" is the ankle, the thorax lies between the shoulders.
constexpr MarkerName human36m[] = {
    {"hip", mid_hips},         {"pelvis", mid_hips},    {"*hip", hip},     {"*knee", knee},
    {"*foot", ankle},          {"*ankle", ankle},       {"spine", chest},  {"belly", chest},
    {"thorax", mid_shoulders}, {"neck/nose", nose},     {"neck", nose},    {"nose", nose},
    {"head", head_top},        {"*shoulder", shoulder}, {"*elbow", elbow}, {"*wrist", wrist},
};

// The 17 keypoints of COCO, as many detectors name them.
constexpr MarkerName coco[] = {
    {"nose", nose},           {"*_eye", eye},     {"*_ear", ear},
    {"*_shoulder", shoulder}, {"*_elbow", elbow}, {"*_wrist", wrist},
    {"*_hip", hip},           {"*_knee", knee},   {"*_ankle", ankle},
};

// OpenPose's BODY_25.
constexpr MarkerName body_25[] = {
    {"Nose", nose},      {"Neck", mid_shoulders}, {"*Shoulder", shoulder}, {"*Elbow", elbow},
    {"*Wrist", wrist},   {"MidHip", mid_hips},    {"*Hip", hip},           {"*Knee", knee},
    {"*Ankle", ankle},   {"*Eye", eye},           {"*Ear", ear},           {"*BigToe", toe_tip},
    {"*SmallToe", foot}, {"*Heel", heel},
};

// HALPE_26, the keypoints of Pose2Sim's usual model.
constexpr MarkerName halpe_26[] = {
    {"Nose", nose},       {"Neck", mid_shoulders}, {"Head", head_top}, {"*Shoulder", shoulder},
    {"*Elbow", elbow},    {"*Wrist", wrist},       {"Hip", mid_hips},  {"*Hip", hip},
    {"*Knee", knee},      {"*Ankle", ankle},       {"*Eye", eye},      {"*Ear", ear},
    {"*BigToe", toe_tip}, {"*SmallToe", foot},     {"*Heel", heel},
};

// Microsoft Kinect for Windows v2 and Azure Kinect.
constexpr MarkerName kinect[] = {
    {"SpineBase", mid_hips}, {"SpineMid", chest},   {"SpineShoulder", mid_shoulders},
    {"Neck", neck},          {"Head", head_centre}, {"Shoulder*", shoulder},
    {"Elbow*", elbow},       {"Wrist*", wrist},     {"Hand*", hand},
    {"HandTip*", hand},      {"Hip*", hip},         {"Knee*", knee},
    {"Ankle*", ankle},       {"Foot*", toe},
};
constexpr MarkerName azure_kinect[] = {
    {"Pelvis", pelvis}, {"Spine_Naval", spine}, {"Spine_Navel", spine},   {"Spine_Chest", chest},
    {"Neck", neck},     {"Head", head},         {"Clavicle_*", clavicle}, {"Shoulder_*", shoulder},
    {"Elbow_*", elbow}, {"Wrist_*", wrist},     {"Hand_*", hand},         {"HandTip_*", hand},
    {"Hip_*", hip},     {"Knee_*", knee},       {"Ankle_*", ankle},       {"Foot_*", toe},
    {"Nose", nose},     {"Eye_*", eye},         {"Ear_*", ear},
};

// MediaPipe's pose landmarks.
constexpr MarkerName media_pipe[] = {
    {"nose", nose},     {"*_eye", eye},     {"*_eye_inner", eye},     {"*_eye_outer", eye},
    {"*_ear", ear},     {"mouth_*", mouth}, {"*_shoulder", shoulder}, {"*_elbow", elbow},
    {"*_wrist", wrist}, {"*_pinky", hand},  {"*_index", hand},        {"*_hip", hip},
    {"*_knee", knee},   {"*_ankle", ankle}, {"*_heel", heel},         {"*_foot_index", toe_tip},
};

// The joints of body.h.
constexpr MarkerName canonical[] = {
    {"Pelvis", pelvis}, {"Spine", spine},        {"Chest", chest},        {"Neck", neck},
    {"Head", head},     {"*Clavicle", clavicle}, {"*Shoulder", shoulder}, {"*Elbow", elbow},
    {"*Wrist", wrist},  {"*Hip", hip},           {"*Knee", knee},         {"*Ankle", ankle},
    {"*Toe", toe},
};

// OptiTrack's skeletons, by their bones: a bone begins at its joint.
constexpr MarkerName optitrack[] = {
    {"Hip", pelvis},  {"Ab", spine},           {"Chest", chest},    {"Neck", neck},
    {"Head", head},   {"*Shoulder", clavicle}, {"*UArm", shoulder}, {"*FArm", elbow},
    {"*Hand", wrist}, {"*Thigh", hip},         {"*Shin", knee},     {"*Foot", ankle},
    {"*Toe", toe},
};

constexpr MarkerName joint_centres[] = {
    {"*HJC", hip},      {"*KJC", knee},  {"*AJC", ankle},
    {"*SJC", shoulder}, {"*EJC", elbow}, {"*WJC", wrist},
};

constexpr MarkerNames sets[] = {
    {"Plug-in Gait", plug_in_gait},
    {"CMU 41 markers", cmu},
    {"IOR (Leardini 2007)", rizzoli},
    {"OpenSim gait", opensim},
    {"OptiTrack markers", optitrack_baseline},
    {"Qualisys markers", qualisys},
    {"OpenCap", opencap},
    {"canonical body", canonical},
    {"SMPL joints", smpl},
    {"Human3.6M joints", human36m},
    {"COCO keypoints", coco},
    {"BODY_25 keypoints", body_25},
    {"HALPE_26 keypoints", halpe_26},
    {"MediaPipe landmarks", media_pipe},
    {"Kinect joints", kinect},
    {"Azure Kinect joints", azure_kinect},
    {"OptiTrack bones", optitrack},
    {"joint centres", joint_centres},
};

}  // namespace

std::span<const MarkerNames> known_marker_sets() { return sets; }

}  // namespace mien::motion
